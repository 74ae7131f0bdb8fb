// The baseline: y = H x by one two-dimensional FFT of the grid padded to 2n x 2n, as most contact codes do it.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "fftw_by_precision.h"

namespace bench {

template <class Real> class PaddedProductIn {
 public:
  // Dimensionless Love kernel. effort: FFTW_ESTIMATE, or FFTW_MEASURE for at most `limit` seconds of planning.
  PaddedProductIn(std::int64_t n, int threads, unsigned effort, double limit);
  ~PaddedProductIn();
  PaddedProductIn(const PaddedProductIn&) = delete;
  PaddedProductIn& operator=(const PaddedProductIn&) = delete;
  void multiply(const Real* x, Real* y);
  double planning_seconds() const { return planning_seconds_; }

 private:
  void make_eigenvalues();

  const std::int64_t n_, half_ = n_ + 1, width_ = 2 * half_;  // 2n rows of half_ complex numbers, in place of 2n real ones
  const int threads_;
  std::unique_ptr<Real[], void (*)(void*)> grid_{nullptr, fftw_free};
  std::vector<Real> eigenvalues_;  // [2n][half_], real because the kernel is symmetric
  typename Fftw<Real>::Plan forward_ = nullptr, backward_ = nullptr;
  double planning_seconds_ = 0;
};

using PaddedProduct = PaddedProductIn<double>;

}  // namespace bench
