// Fourier transforms of many complex sequences side by side, one to a lane of a vector register, so that no arithmetic crosses
// lanes. Waves are not sorted after the transform.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "lengths.h"
#include "passes.h"
#include "sequences.h"

namespace rc_fft {

template <class Real> class Fourier {
 public:
  explicit Fourier(std::int64_t length, rc_common::Vectors vectors = rc_common::widest_vectors());
  ~Fourier();
  Fourier(const Fourier&) = delete;
  Fourier& operator=(const Fourier&) = delete;

  std::int64_t length() const { return plan_.length; }
  std::int64_t waves() const { return plan_.length / 2 + 1; }  // that determine the others where lines are real
  // Place of the waves k and length - k, 0 <= k <= length/2, among those. That of k = 0 is 0.
  std::int64_t rank(std::int64_t k) const { return rank_[static_cast<std::size_t>(k)]; }
  // Rows of the scratch, by rank; rounded up to a multiple of `width` with others.
  const Mirrored* rows() const { return rows_.data(); }
  const Passes<Real>& passes() const { return *plan_.passes; }

  // Rows of scratch that the functions below need. Nothing reads the last one.
  static std::int64_t scratch_rows(std::int64_t length);
  Real* spare_row(Real* scratch) const { return scratch + (scratch_rows(plan_.length) - 1) * row_size<Real>; }

  // Wave k of x: sum over j of x[j] exp(-2 pi i jk/length), left in the scratch.
  void forward(Source<Real>& x, Real* scratch) const;
  // From the waves in the scratch, length times the sequence.
  void backward(Real* scratch, Sink<Real>& y) const;
  // Both; in between wave k of sequence c is multiplied by eigenvalues[rank(k) * width + c].
  void multiply(Source<Real>& x, const Real* eigenvalues, Real* scratch, Sink<Real>& y) const;

 private:
  struct Chirp;

  void set_up_passes();
  void append(std::size_t level, std::int64_t row, std::int64_t length);
  template <bool Exchanged> void convolve(Real* rows) const;
  void multiply_by(const Factors<Real>& factors, Source<Real>& x, Real* scratch, Sink<Real>& y) const;

  Plan<Real> plan_;
  std::vector<std::size_t> offsets_;  // of each pass's twiddle factors
  std::vector<std::int32_t> rank_;
  std::vector<Mirrored> rows_;
  std::unique_ptr<const Chirp> chirp_;  // where the length has large prime factors
};

// Along x and along y.
template <class Real> struct Axes {
  Axes() = default;
  explicit Axes(Lengths lengths)
      : x(std::make_shared<const Fourier<Real>>(lengths.x)),
        y(lengths.y == lengths.x ? x : std::make_shared<const Fourier<Real>>(lengths.y)) {}

  std::shared_ptr<const Fourier<Real>> x, y;
};

}  // namespace rc_fft
