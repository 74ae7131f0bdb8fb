// The grid points of a vector's entries.
#pragma once

#include <cstdint>
#include <roughcontact/plugin.hpp>
#include <vector>

#include "common/domain.h"
#include "conversion.h"

namespace rc_fft {

using rc_common::Box;

// The points of a domain, row by row of its box: vector entries in a row are consecutive.
class Points {
 public:
  Points() = default;
  // Every point of a box.
  Points(std::int64_t nx, std::int64_t ny) : nx_(nx), ny_(ny) {}
  // A domain of a grid with rows of grid_nx points.
  Points(const rc_domain& domain, const Box& box, std::int64_t grid_nx);

  std::int64_t nx() const { return nx_; }
  std::int64_t rows() const { return ny_; }
  std::int64_t count() const { return begin(ny_); }
  bool row_is_empty(std::int64_t row) const { return begin(row) == begin(row + 1); }
  // A row's entries of x where it is a line of nx() values as it is, else null.
  template <class Real> Real* row(std::int64_t row, Real* x) const { return full() ? x + begin(row) : nullptr; }
  template <class Real> bool row_is_zero(std::int64_t row, const Real* x) const;
  // Puts a row's entries of x into a line of nx() values, zero elsewhere; and back.
  template <class Outer, class Real> void scatter(std::int64_t row, const Outer* x, Real* line, const Conversion& convert) const;
  template <class Real, class Outer> void gather(std::int64_t row, const Real* line, Outer* y, const Conversion& convert) const;

 private:
  bool full() const { return columns_.empty(); }
  std::int64_t begin(std::int64_t row) const { return full() ? row * nx_ : begin_[static_cast<std::size_t>(row)]; }

  std::int64_t nx_ = 0, ny_ = 0;
  std::vector<std::int64_t> begin_;    // of each row among the entries; empty if every point of the box has one
  std::vector<std::int32_t> columns_;  // of each entry, from the box's first column; likewise
};

}  // namespace rc_fft
