// The smooth part of H between the nodes of a coarse grid, by a circular convolution so long that no node meets its images.
#pragma once

#include <cstdint>
#include <functional>
#include <roughcontact/plugin.hpp>

#include "aligned.h"
#include "common/fftw.h"

namespace rc_split {

using rc_common::Fftw, rc_common::PlannerLock;

struct Axis {
  std::int64_t nodes;                             // nodes that are wanted
  std::int64_t bend;                              // further nodes, over which the kernel is made even about the far end
  std::function<double(double theta)> transform;  // of the window
};

template <class T> class Convolution {
 public:
  // kernel(x, y): the smooth part at a distance in coarse cells.
  Convolution(const rc_host* host, const rc_team& team, const Axis& x, const Axis& y,
              const std::function<double(double x, double y)>& kernel);
  ~Convolution();
  Convolution(const Convolution&) = delete;
  Convolution& operator=(const Convolution&) = delete;

  // How many nodes it has room for, along each axis.
  std::int64_t nodes_x() const { return nodes_x_; }
  std::int64_t nodes_y() const { return nodes_y_; }

  // One row of nodes: row_length() values. Those beyond the nodes must be 0 before forward().
  T* row(std::int64_t i) { return rows_.data() + i * stride_; }
  const T* row(std::int64_t i) const { return rows_.data() + i * stride_; }
  std::int64_t row_length() const { return length_x_; }
  std::int64_t stride() const { return stride_; }

  // One product: forward() of each of the first `rows` rows, columns(), backward() of each.
  void forward(std::int64_t i, std::int64_t thread);
  void columns(std::int64_t rows, bool parallel);
  void backward(std::int64_t i, std::int64_t thread);

 private:
  void make_plans();
  void destroy_plans();
  void load(const Axis& x, const Axis& y, const std::function<double(double, double)>& kernel);
  void multiply_column(T* column, T* waves, const T* eigenvalues) const;
  T* scratch(std::int64_t thread) { return scratch_.data() + thread * scratch_size_; }

  const rc_host* host_;
  const rc_team& team_;
  std::int64_t nodes_x_, nodes_y_, length_x_, length_y_, half_x_, half_y_, stride_, column_stride_;
  std::int64_t scratch_size_;  // of a thread: a line, and columns
  typename Fftw<T>::Plan forward_x_ = nullptr, backward_x_ = nullptr, forward_y_ = nullptr, backward_y_ = nullptr;
  Array<T> rows_, scratch_, eigenvalues_;  // eigenvalues [wave number along x][wave number along y] / (lengths)
};

}  // namespace rc_split
