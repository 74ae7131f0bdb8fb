// The baseline: y = H x by one two-dimensional FFT of the grid padded to 2n x 2n, as most contact codes do it.
#pragma once

#include <fftw3.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace bench {

class PaddedProduct {
 public:
  // Dimensionless Love kernel. effort: FFTW_ESTIMATE, or FFTW_MEASURE for at most `limit` seconds of planning.
  PaddedProduct(std::int64_t n, int threads, unsigned effort, double limit);
  ~PaddedProduct();
  PaddedProduct(const PaddedProduct&) = delete;
  PaddedProduct& operator=(const PaddedProduct&) = delete;
  void multiply(const double* x, double* y);
  double planning_seconds() const { return planning_seconds_; }

 private:
  void make_eigenvalues();

  const std::int64_t n_, half_ = n_ + 1, width_ = 2 * half_;  // 2n rows of half_ complex numbers, in place of 2n real ones
  const int threads_;
  std::unique_ptr<double[], void (*)(void*)> grid_{nullptr, fftw_free};
  std::vector<double> eigenvalues_;  // [2n][half_], real because the kernel is symmetric
  fftw_plan forward_ = nullptr, backward_ = nullptr;
  double planning_seconds_ = 0;
};

}  // namespace bench
