// The baseline: y = H x by one two-dimensional FFT of the grid padded to 2n x 2n, as most contact codes do it.
#pragma once

#include <fftw3.h>
#include <roughcontact/registry.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "stopwatch.h"

namespace bench {

// FFTW's two libraries under one name, by precision.
template <class Real> struct Fftw;
#define RC_FFTW(Real, name)                                              \
  template <> struct Fftw<Real> {                                        \
    using Plan = name##_plan;                                            \
    using Complex = name##_complex;                                      \
    static constexpr auto alloc_real = name##_alloc_real;                \
    static constexpr auto init_threads = name##_init_threads;            \
    static constexpr auto plan_with_threads = name##_plan_with_nthreads; \
    static constexpr auto set_time_limit = name##_set_timelimit;         \
    static constexpr auto plan_complex = name##_plan_dft_1d;             \
    static constexpr auto plan_real_2d = name##_plan_dft_r2c_2d;         \
    static constexpr auto plan_real_back_2d = name##_plan_dft_c2r_2d;    \
    static constexpr auto execute = name##_execute;                      \
    static constexpr auto destroy = name##_destroy_plan;                 \
  }
RC_FFTW(double, fftw);
RC_FFTW(float, fftwf);
#undef RC_FFTW

inline rc_status check(rc_status status) {
  if (status < 0) throw std::runtime_error(std::string(rc_status_name(status)) + ": " + rc_last_error());
  return status;
}

// work(first, last) on equal shares of the rows.
template <class Work> void share_rows(std::int64_t rows, int threads, const Work& work) {
  std::vector<std::jthread> helpers;
  for (int t = 1; t < threads; ++t) helpers.emplace_back([&, t] { work(rows * t / threads, rows * (t + 1) / threads); });
  work(0, rows / threads);
}

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

template <class Real>
PaddedProductIn<Real>::PaddedProductIn(std::int64_t n, int threads, unsigned effort, double limit)
    : n_(n), threads_(threads), eigenvalues_(static_cast<std::size_t>(2 * n * (n + 1))) {
  grid_.reset(Fftw<Real>::alloc_real(static_cast<std::size_t>(2 * n_ * width_)));
  if (!grid_) throw std::bad_alloc();
  const auto start = Clock::now();
  Fftw<Real>::init_threads();
  Fftw<Real>::plan_with_threads(threads);
  Fftw<Real>::set_time_limit(limit / 2);
  const int length = static_cast<int>(2 * n);
  auto* const complex = reinterpret_cast<typename Fftw<Real>::Complex*>(grid_.get());
  forward_ = Fftw<Real>::plan_real_2d(length, length, grid_.get(), complex, effort);
  backward_ = Fftw<Real>::plan_real_back_2d(length, length, complex, grid_.get(), effort);
  if (!forward_ || !backward_) throw std::runtime_error("FFTW made no plan");
  planning_seconds_ = seconds_since(start);
  make_eigenvalues();
}

template <class Real> PaddedProductIn<Real>::~PaddedProductIn() {
  Fftw<Real>::destroy(forward_);
  Fftw<Real>::destroy(backward_);
}

template <class Real> void PaddedProductIn<Real>::make_eigenvalues() {
  std::vector<double> kernel(static_cast<std::size_t>((n_ + 1) * (n_ + 1)));
  check(rc_kernel_coefficients("love", 1, 1, n_ + 1, n_ + 1, kernel.data()));
  for (std::int64_t iy = 0; iy < 2 * n_; ++iy)
    for (std::int64_t ix = 0; ix < 2 * n_; ++ix)
      grid_[static_cast<std::size_t>(iy * width_ + ix)] =
          static_cast<Real>(kernel[static_cast<std::size_t>(std::min(iy, 2 * n_ - iy) * (n_ + 1) + std::min(ix, 2 * n_ - ix))]);
  Fftw<Real>::execute(forward_);
  const Real scale = 1 / static_cast<Real>(4 * n_ * n_);
  for (std::size_t i = 0; i < eigenvalues_.size(); ++i) eigenvalues_[i] = scale * grid_[2 * i];
}

template <class Real> void PaddedProductIn<Real>::multiply(const Real* x, Real* y) {
  Real* const grid = grid_.get();
  share_rows(2 * n_, threads_, [&](std::int64_t first, std::int64_t last) {
    for (std::int64_t iy = first; iy < last; ++iy) {
      const std::int64_t given = iy < n_ ? n_ : 0;
      std::copy_n(x + iy * given, given, grid + iy * width_);
      std::fill(grid + iy * width_ + given, grid + (iy + 1) * width_, Real{0});
    }
  });
  Fftw<Real>::execute(forward_);
  share_rows(2 * n_, threads_, [&](std::int64_t first, std::int64_t last) {
    for (std::int64_t i = first * half_; i < last * half_; ++i) {
      const Real factor = eigenvalues_[static_cast<std::size_t>(i)];
      grid[2 * i] *= factor;
      grid[2 * i + 1] *= factor;
    }
  });
  Fftw<Real>::execute(backward_);
  share_rows(n_, threads_, [&](std::int64_t first, std::int64_t last) {
    for (std::int64_t iy = first; iy < last; ++iy) std::copy_n(grid + iy * width_, n_, y + iy * n_);
  });
}

using PaddedProduct = PaddedProductIn<double>;

}  // namespace bench
