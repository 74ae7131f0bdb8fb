// Points of a grid by the blocks of factor x factor that are the cells of a coarser one.
#pragma once

#include <cstdint>
#include <span>

#include "contact/pressures.h"
#include "contact/surface_state.h"
#include "grid/downsample.h"

namespace rc {

struct Blocks {
  std::int64_t nx = 0, ny = 0;  // of the fine grid
  std::int64_t factor = 1;

  std::int64_t coarse_nx() const { return (nx + factor - 1) / factor; }
  std::int64_t coarse_ny() const { return (ny + factor - 1) / factor; }
  std::int64_t of(std::int64_t point) const { return point / nx / factor * coarse_nx() + point % nx / factor; }
  // How many of a block's points count.
  std::int64_t included(std::int64_t block, const SurfaceState& fine) const;
};

// Means over blocks of 2 x 2 points of an nx x ny surface.
CoarseGrid halved(const SurfaceState& surface, std::int64_t nx, std::int64_t ny, const rc_team& team);

enum class Cut {  // of blocks at the end of the grid or of the mask
  same_pressure,
  same_force
};

// Positive pressures of blocks, each on its included points.
Pressures spread(const Pressures& coarse, const Blocks& blocks, const SurfaceState& fine, Cut cut);

// Rms of gap less that of its block, over the points that carry pressure.
double left_out(const Pressures& p, const Blocks& blocks, const SurfaceState& fine, std::span<const double> coarse_gap);

}  // namespace rc
