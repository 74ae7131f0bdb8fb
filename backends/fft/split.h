// Fourier transforms of a few long real lines: each pair of lines is split into as many sequences as fill the lanes.
#pragma once

#include <cstdint>
#include <vector>

#include "lines.h"

namespace rc_fft {

// With W = `width` and n = W m, the waves W k + q of a sequence x of length n are the waves k of the sequence
// exp(-2 pi i jq/n) * sum over l of x[l m + j] exp(-2 pi i lq/W), 0 <= j < m. Two real lines make a complex sequence.
template <class Real> class Split {
 public:
  // Whether so few lines of this length, as many as transforms across them have elements, are better split.
  static bool suits(Lengths lengths);

  explicit Split(std::int64_t length);

  // Reals that the functions below need besides the scratch of a transform of the whole length.
  std::int64_t room() const { return row_size<Real> * part_; }

  // The waves of two lines, in the spectra of one group of lines: of each block of W waves the row of the first line, with real
  // parts and imaginary parts, and the row of the second. Lines have `given` elements and are zero from there on; a line that is
  // null is zero.
  void forward(const Real* const* pair, std::int64_t given, Real* scratch, Real* room, Real* spectra) const;
  // Back, without the factor, for the first `wanted` elements. Lines may be null. `both`: the second line has waves.
  void backward(const Real* spectra, bool both, Real* scratch, Real* room, Real* const* pair, std::int64_t wanted) const;

 private:
  class From;
  class To;

  // visit(q, row) for the waves across the parts: rows of the scratch of across_.
  template <class Visit> void for_each_sequence(const Visit& visit) const;
  Real* row(Real* scratch, std::int64_t k) const { return scratch + rows_[static_cast<std::size_t>(k)] * row_size<Real>; }
  // visit(k, q, z, mirror) for the waves W k + q up to n/2: addresses of the real parts of the wave and of wave n - W k - q.
  template <class Visit> void for_each_wave(Real* scratch, const Visit& visit) const;

  std::int64_t part_;               // m
  Fourier<Real> across_, along_;    // of length W, and of length m
  std::vector<std::int64_t> rows_;  // of the scratch, of each wave along
  std::vector<Real> turns_;         // exp(-2 pi i jq/n): [j / W][q], W real parts and W imaginary parts
};

}  // namespace rc_fft
