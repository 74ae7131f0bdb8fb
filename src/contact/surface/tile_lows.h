// The tiles of a surface: squares of 16 x 16 points from the first on; those at the ends may be cut off.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace rc {

struct TileLows {
  static constexpr std::int64_t side = 16;

  std::int64_t nx = 0, ny = 0;  // of the surface
  // The lowest gap of each tile's included points; infinite if a tile has none. A surface of gathered tiles has no such list.
  std::vector<double> lowest = {};

  std::int64_t columns() const { return (nx + side - 1) / side; }
  std::int64_t rows() const { return (ny + side - 1) / side; }
  std::int64_t of(std::int64_t point) const { return point / nx / side * columns() + point % nx / side; }
  // act(point) for the points of a tile, row by row.
  template <class Act> void each_point(std::int64_t tile, const Act& act) const {
    const std::int64_t left = tile % columns() * side, low = tile / columns() * side;
    for (std::int64_t y = low; y < std::min(low + side, ny); ++y)
      for (std::int64_t x = left; x < std::min(left + side, nx); ++x) act(y * nx + x);
  }
};

}  // namespace rc
