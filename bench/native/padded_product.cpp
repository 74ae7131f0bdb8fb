#include "padded_product.h"

#include <algorithm>
#include <new>
#include <thread>

#include "library.h"
#include "stopwatch.h"

namespace bench {

namespace {

// work(first, last) on equal shares of the rows.
template <class Work> void share_rows(std::int64_t rows, int threads, const Work& work) {
  std::vector<std::jthread> helpers;
  for (int t = 1; t < threads; ++t) helpers.emplace_back([&, t] { work(rows * t / threads, rows * (t + 1) / threads); });
  work(0, rows / threads);
}

}  // namespace

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

template class PaddedProductIn<double>;
template class PaddedProductIn<float>;

}  // namespace bench
