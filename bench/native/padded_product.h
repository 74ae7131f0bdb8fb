// The baseline: y = H x by one two-dimensional FFT of the grid padded to 2n x 2n, as most contact codes do it.
#pragma once

#include <fftw3.h>
#include <roughcontact/registry.h>

#include <memory>
#include <stdexcept>

#include "common.h"

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
    static constexpr auto plan_real_2d = name##_plan_dft_r2c_2d;         \
    static constexpr auto plan_real_back_2d = name##_plan_dft_c2r_2d;    \
    static constexpr auto execute = name##_execute;                      \
    static constexpr auto destroy = name##_destroy_plan;                 \
  }
RC_FFTW(double, fftw);
RC_FFTW(float, fftwf);
#undef RC_FFTW

struct FftwFree {
  void operator()(void* data) const { fftw_free(data); }
};
template <class Real> using FftwArray = std::unique_ptr<Real[], FftwFree>;

inline void check(rc_status status) {
  if (status < 0) throw std::runtime_error(std::string(rc_status_name(status)) + ": " + rc_last_error());
}

template <class Real> class PaddedProduct {
  using Library = Fftw<Real>;

 public:
  // Dimensionless Love kernel. effort: FFTW_ESTIMATE, or FFTW_MEASURE for at most `limit` seconds of planning.
  PaddedProduct(std::int64_t n, std::int64_t threads, unsigned effort, double limit)
      : n_(n), threads_(threads), grid_(Library::alloc_real(static_cast<std::size_t>(2 * n * width_))) {
    if (!grid_) throw std::bad_alloc();
    const auto start = Clock::now();
    Library::init_threads();
    Library::plan_with_threads(static_cast<int>(threads));
    Library::set_time_limit(limit / 2);
    const int length = static_cast<int>(2 * n);
    auto* const complex = reinterpret_cast<typename Library::Complex*>(grid_.get());
    forward_ = Library::plan_real_2d(length, length, grid_.get(), complex, effort);
    backward_ = Library::plan_real_back_2d(length, length, complex, grid_.get(), effort);
    if (!forward_ || !backward_) throw std::runtime_error("FFTW made no plan");
    planning_seconds_ = seconds_since(start);
    std::vector<double> kernel(static_cast<std::size_t>(half_ * half_));
    check(rc_kernel_coefficients("love", 1, 1, half_, half_, kernel.data()));
    for (std::int64_t iy = 0; iy < 2 * n; ++iy)
      for (std::int64_t ix = 0; ix < 2 * n; ++ix)
        grid_[static_cast<std::size_t>(iy * width_ + ix)] =
            static_cast<Real>(kernel[static_cast<std::size_t>(std::min(iy, 2 * n - iy) * half_ + std::min(ix, 2 * n - ix))]);
    Library::execute(forward_);
    const Real scale = 1 / static_cast<Real>(4 * n * n);
    for (std::size_t i = 0; i < eigenvalues_.size(); ++i) eigenvalues_[i] = scale * grid_[2 * i];
  }
  ~PaddedProduct() {
    Library::destroy(forward_);
    Library::destroy(backward_);
  }
  PaddedProduct(const PaddedProduct&) = delete;
  PaddedProduct& operator=(const PaddedProduct&) = delete;

  void multiply(const Real* x, Real* y) {
    Real* const grid = grid_.get();
    in_parallel(2 * n_, threads_, [&](std::size_t, std::int64_t first, std::int64_t last) {
      for (std::int64_t iy = first; iy < last; ++iy) {
        const std::int64_t given = iy < n_ ? n_ : 0;
        std::copy_n(x + iy * given, given, grid + iy * width_);
        std::fill(grid + iy * width_ + given, grid + (iy + 1) * width_, Real{0});
      }
    });
    Library::execute(forward_);
    in_parallel(2 * n_ * half_, threads_, [&](std::size_t, std::int64_t first, std::int64_t last) {
      for (std::int64_t i = first; i < last; ++i) {
        const Real factor = eigenvalues_[static_cast<std::size_t>(i)];
        grid[2 * i] *= factor;
        grid[2 * i + 1] *= factor;
      }
    });
    Library::execute(backward_);
    in_parallel(n_, threads_, [&](std::size_t, std::int64_t first, std::int64_t last) {
      for (std::int64_t iy = first; iy < last; ++iy) std::copy_n(grid + iy * width_, n_, y + iy * n_);
    });
  }

  double planning_seconds() const { return planning_seconds_; }

 private:
  const std::int64_t n_, threads_, half_ = n_ + 1, width_ = 2 * half_;  // 2n rows of half_ complex numbers, in place of 2n real
  FftwArray<Real> grid_;
  std::vector<Real> eigenvalues_ = std::vector<Real>(static_cast<std::size_t>(2 * n_ * half_));  // the kernel is symmetric: real
  typename Library::Plan forward_ = nullptr, backward_ = nullptr;
  double planning_seconds_ = 0;
};

}  // namespace bench
