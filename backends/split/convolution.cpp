#include "convolution.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "common/planner_memory.h"
#include "cosines.h"
#include "failure.h"

namespace rc_split {

namespace {

// Columns that share the cache lines of a row.
constexpr std::int64_t columns_per_block = 8;

std::int64_t whole_lines(std::int64_t values) { return (values + 15) / 16 * 16; }

// The least multiple of 4 without prime factors above 5.
std::int64_t transform_length(std::int64_t at_least) {
  std::int64_t best = std::numeric_limits<std::int64_t>::max();
  for (std::int64_t p5 = 1; p5 < at_least; p5 *= 5)
    for (std::int64_t p3 = p5; p3 < at_least; p3 *= 3) {
      std::int64_t length = 4 * p3;
      while (length < at_least) length *= 2;
      best = std::min(best, length);
    }
  return best;
}

// The distances at which the circular kernel is evaluated: m up to `straight`, then growing ever more slowly, flat at `end`. This
// makes the kernel even about `end` and smooth there.
std::vector<double> bent(std::int64_t straight, std::int64_t end) {
  std::vector<double> distance(static_cast<std::size_t>(end) + 1);
  constexpr int parts = 8;
  const double width = static_cast<double>(end - straight);
  double sum = static_cast<double>(straight);
  for (std::int64_t m = 0; m <= end; ++m) {
    if (m <= straight) {
      distance[static_cast<std::size_t>(m)] = static_cast<double>(m);
      continue;
    }
    for (int i = 0; i < parts; ++i) {
      const double t = (static_cast<double>(m - 1 - straight) + (i + 0.5) / parts) / width;
      sum += 0.5 * std::erfc(8 * (t - 0.5)) / parts;
    }
    distance[static_cast<std::size_t>(m)] = sum;
  }
  return distance;
}

}  // namespace

template <class T>
Convolution<T>::Convolution(const rc_host* host, const rc_team& team, const Axis& x, const Axis& y,
                            const std::function<double(double, double)>& kernel)
    : host_(host), team_(team) {
  length_x_ = transform_length(2 * (x.nodes + x.bend));
  length_y_ = transform_length(2 * (y.nodes + y.bend));
  half_x_ = length_x_ / 2 + 1;
  half_y_ = length_y_ / 2 + 1;
  nodes_x_ = length_x_ / 2 - x.bend;
  nodes_y_ = length_y_ / 2 - y.bend;
  stride_ = whole_lines(2 * half_x_);
  if (stride_ * static_cast<std::int64_t>(sizeof(T)) % 4096 == 0)
    stride_ += 16;  // else rows would compete for the same cache sets
  column_stride_ = whole_lines(2 * length_y_) + 16;
  make_room(rows_, nodes_y_ * stride_);
  scratch_size_ = std::max(stride_, (columns_per_block + 1) * column_stride_);
  make_room(scratch_, team_.threads * scratch_size_);
  make_room(eigenvalues_, half_x_ * half_y_);
  load(x, y, kernel);
  make_plans();
}

template <class T> Convolution<T>::~Convolution() { destroy_plans(); }

template <class T> void Convolution<T>::make_plans() {
  T *const line = scratch(0), *const column = line + column_stride_;
  const int nx = static_cast<int>(length_x_), ny = static_cast<int>(length_y_);
  if (!rc_common::planner_has_memory(length_x_ + length_y_))
    fail(RC_ERR_MEMORY, "cannot allocate the memory to plan a ", nx, "x", ny, " transform; use a coarser grid");
  {
    const PlannerLock<T> lock(host_);
    forward_x_ = Fftw<T>::real_to_complex(nx, row(0), line, FFTW_ESTIMATE);
    backward_x_ = Fftw<T>::complex_to_real(nx, row(0), line, FFTW_ESTIMATE);
    forward_y_ = Fftw<T>::complex_to_complex(ny, column, line, FFTW_FORWARD, FFTW_ESTIMATE);
    backward_y_ = Fftw<T>::complex_to_complex(ny, line, column, FFTW_BACKWARD, FFTW_ESTIMATE);
  }
  if (forward_x_ && backward_x_ && forward_y_ && backward_y_) return;
  destroy_plans();
  fail(RC_ERR_INTERNAL, "FFTW made no plan for a ", length_x_, "x", length_y_, " transform; check the FFTW installation");
}

template <class T> void Convolution<T>::destroy_plans() {
  const PlannerLock<T> lock(host_);
  for (auto plan : {forward_x_, backward_x_, forward_y_, backward_y_}) Fftw<T>::destroy(plan);
}

// The kernel is even, so its transform is a cosine transform. Spreading and interpolating each multiply by the window's
// transform, which is divided out here.
template <class T> void Convolution<T>::load(const Axis& x, const Axis& y, const std::function<double(double, double)>& kernel) {
  const std::vector<double> along_x = bent(nodes_x_, length_x_ / 2), along_y = bent(nodes_y_, length_y_ / 2);
  Array<double> table(static_cast<std::size_t>(half_x_ * half_y_));
  roughcontact::for_each(team_, half_y_, true, [&](std::int64_t my, std::int64_t) {
    for (std::int64_t mx = 0; mx < half_x_; ++mx)
      table[static_cast<std::size_t>(my * half_x_ + mx)] =
          kernel(along_x[static_cast<std::size_t>(mx)], along_y[static_cast<std::size_t>(my)]);
  });
  const auto weights = [](const Axis& axis, std::int64_t length) {
    std::vector<double> inverse;
    for (std::int64_t k = 0; k <= length / 2; ++k) {
      const double window = axis.transform(2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(length));
      inverse.push_back(1 / (window * window * static_cast<double>(length)));
    }
    return inverse;
  };
  const std::vector<double> by_x = weights(x, length_x_), by_y = weights(y, length_y_);
  transform_even(host_, team_, half_x_, half_y_, table.data());
  for (std::int64_t ky = 0; ky < half_y_; ++ky)
    for (std::int64_t kx = 0; kx < half_x_; ++kx)
      eigenvalues_[static_cast<std::size_t>(kx * half_y_ + ky)] =
          static_cast<T>(table[static_cast<std::size_t>(ky * half_x_ + kx)] * by_x[static_cast<std::size_t>(kx)] *
                         by_y[static_cast<std::size_t>(ky)]);
}

template <class T> void Convolution<T>::forward(std::int64_t i, std::int64_t thread) {
  T* const line = scratch(thread);
  Fftw<T>::run_real_to_complex(forward_x_, row(i), line);
  std::copy_n(line, 2 * half_x_, row(i));
}

template <class T> void Convolution<T>::backward(std::int64_t i, std::int64_t thread) {
  T* const line = scratch(thread);
  Fftw<T>::run_complex_to_real(backward_x_, row(i), line);
  std::copy_n(line, length_x_, row(i));
}

template <class T> void Convolution<T>::multiply_column(T* column, T* waves, const T* eigenvalues) const {
  Fftw<T>::run_complex(forward_y_, column, waves);
  for (std::int64_t k = 0; k < half_y_; ++k) {
    waves[2 * k] *= eigenvalues[k];
    waves[2 * k + 1] *= eigenvalues[k];
  }
  for (std::int64_t k = half_y_; k < length_y_; ++k) {
    waves[2 * k] *= eigenvalues[length_y_ - k];
    waves[2 * k + 1] *= eigenvalues[length_y_ - k];
  }
  Fftw<T>::run_complex(backward_y_, waves, column);
}

template <class T> void Convolution<T>::columns(std::int64_t rows, bool parallel) {
  const std::int64_t blocks = (half_x_ + columns_per_block - 1) / columns_per_block;
  roughcontact::for_each(team_, blocks, parallel, [&](std::int64_t block, std::int64_t thread) {
    const std::int64_t first = block * columns_per_block, width = std::min(columns_per_block, half_x_ - first);
    T *const waves = scratch(thread), *const column_block = waves + column_stride_;
    for (std::int64_t i = 0; i < rows; ++i)
      for (std::int64_t c = 0; c < width; ++c) {
        column_block[c * column_stride_ + 2 * i] = row(i)[2 * (first + c)];
        column_block[c * column_stride_ + 2 * i + 1] = row(i)[2 * (first + c) + 1];
      }
    for (std::int64_t c = 0; c < width; ++c) {
      T* const column = column_block + c * column_stride_;
      std::fill(column + 2 * rows, column + 2 * length_y_, T(0));
      multiply_column(column, waves, eigenvalues_.data() + (first + c) * half_y_);
    }
    for (std::int64_t i = 0; i < rows; ++i)
      for (std::int64_t c = 0; c < width; ++c) {
        row(i)[2 * (first + c)] = column_block[c * column_stride_ + 2 * i];
        row(i)[2 * (first + c) + 1] = column_block[c * column_stride_ + 2 * i + 1];
      }
  });
}

template class Convolution<float>;
template class Convolution<double>;

}  // namespace rc_split
