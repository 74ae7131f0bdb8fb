// One level of the cascade of coarser grids: blocks of 2 x 2 points become one (Bemporad & Paggi 2015, section 5).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "grid/gap_values.h"

namespace rc {

// The value that a coarse point takes from the points of its block.
enum class Filter {
  subsample,  // the point at even ix and iy, or the next one that is not masked: the coarser stages of midpoint displacement
  mean,       // the mean gap
  max         // of the heights, that is the smallest gap: no peak is lost
};

struct CoarseGrid {
  std::int64_t nx, ny;             // half of the fine grid's, rounded up
  std::vector<double> gap;         // infinite where the mask is 0
  std::vector<std::uint8_t> mask;  // empty if the fine grid had none; 0 if every point of the block is masked
};

// Halves a grid of nx * ny gaps, point (ix, iy) at iy*nx + ix. Coarse point (ix, iy) stands for the fine points 2*ix, 2*ix + 1 by
// 2*iy, 2*iy + 1; of odd sizes the last blocks are smaller. mask empty: all points; 0: the point's gap is not read.
// each_row(rows, act) calls act(row) for every coarse row, in any order and by any threads.
using EachRow = std::function<void(std::int64_t rows, const std::function<void(std::int64_t)>& act)>;
CoarseGrid downsample(std::int64_t nx, std::int64_t ny, const GapValues& gap, std::span<const std::uint8_t> mask, Filter filter,
                      const EachRow& each_row = {});

// Halves it so many times (>= 1) by the mean, and keeps no grid between.
CoarseGrid downsample(std::int64_t nx, std::int64_t ny, const GapValues& gap, std::span<const std::uint8_t> mask, int halvings,
                      const EachRow& each_row);

}  // namespace rc
