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

  // Waves of a line: in blocks of W, `stride` reals apart, the block's real parts and imaginary parts; in their order, twice.
  // Lines have `given` elements and are zero from there on. A line that is null is zero. The waves of `other` follow a row after
  // those of `line`.
  void forward(const Real* line, const Real* other, std::int64_t given, Real* scratch, Real* room, Real* spectra,
               std::int64_t stride) const;
  // Back, without the factor, for the first `wanted` elements. Lines may be null. `both`: whether there are waves of `other`.
  void backward(const Real* spectra, std::int64_t stride, bool both, Real* scratch, Real* room, Real* line, Real* other,
                std::int64_t wanted) const;

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
