// Real lines of even length P as complex ones of length M = P/2: even elements are the real parts, odd ones the imaginary parts.
// Complex transforms of FFTW are several times as fast as its real ones in single precision.
#pragma once

#include <complex>
#include <cstdint>
#include <vector>

namespace rc_fft {

// With Z the transform of the complex line, X that of the real one and w = exp(-2 pi i/P), for 0 <= k <= M (Cooley, Lewis & Welch
// 1970): 2 X[k] = Z[k] + conj Z[M-k] - i w^k (Z[k] - conj Z[M-k]) with Z[M] = Z[0]. Back it is
// Z[k] = X[k] + conj X[M-k] + i w^-k (X[k] - conj X[M-k]), for a complex transform that gives P x from X.
template <class Real> class HalfLength {
 public:
  explicit HalfLength(std::int64_t length);

  void to_real(std::complex<Real>* row) const { to_real_(*this, row); }      // Z[0..M-1] -> 2 X[0..M]
  void from_real(std::complex<Real>* row) const { from_real_(*this, row); }  // X[0..M] -> Z[0..M-1]

  std::int64_t half() const { return half_; }
  // -i w^k, 0 <= k <= M/2.
  const Real* re() const { return re_.data(); }
  const Real* im() const { return im_.data(); }

 private:
  using Pass = void (*)(const HalfLength&, std::complex<Real>*);

  std::int64_t half_;
  std::vector<Real> re_, im_;
  Pass to_real_, from_real_;
};

}  // namespace rc_fft
