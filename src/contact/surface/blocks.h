// Pressures that go from one grid to another: the blocks of points that are the cells of a coarser grid.
#pragma once

#include <cstdint>

#include "contact/surface/pressures.h"
#include "contact/surface/step_surface.h"
#include "grid/gap_values.h"

namespace rc {

// The blocks of factor x factor points of a grid that are the cells of a coarser one.
struct Blocks {
  std::int64_t nx = 0, ny = 0;  // of the fine grid
  std::int64_t factor = 1;

  std::int64_t coarse_nx() const { return (nx + factor - 1) / factor; }
  std::int64_t coarse_ny() const { return (ny + factor - 1) / factor; }
  std::int64_t of(std::int64_t point) const { return point / nx / factor * coarse_nx() + point % nx / factor; }
  // All points of the blocks that carry pressure.
  std::vector<std::int64_t> points_under(const Pressures& coarse) const;
  // How many of a block's points are not masked.
  std::int64_t included(std::int64_t block, const StepSurface& fine) const;
};

enum class Cut {  // what blocks keep that the end of the grid or the mask cuts
  same_pressure,
  same_force
};

// Puts the positive pressure of each block on the block's included points.
Pressures spread(const Pressures& coarse, const Blocks& blocks, const StepSurface& fine, Cut cut);

// Rms of the difference between the gap and its block's gap, over the points that carry pressure.
double left_out(const Pressures& p, const Blocks& blocks, const StepSurface& fine, const GapValues& coarse_gap);

}  // namespace rc
