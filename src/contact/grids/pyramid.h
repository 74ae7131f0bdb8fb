// Coarser grids: the systems, surfaces, options and contacts on them, and pressures that go from one grid to another.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "contact/surface/pressures.h"
#include "contact/surface/step_surface.h"
#include "grid/downsample.h"
#include "registry/options_handle.h"

namespace rc {

class GridContact;
class Monitor;
class Workspace;

// The system on nx x ny cells, each `factor` cells wide and high.
rc_system coarser_system(const rc_system& fine, std::int64_t nx, std::int64_t ny, std::int64_t factor);
// Options of a coarser grid: no bounds, and the time that the finest grid has left.
rc_options coarse_options(const rc_options& fine, const Monitor& monitor);

// A grid of half as many points a side, each the mean of 2 x 2; or halved so several times. Of a surface of which ranks gather
// tiles each halves its rows, once; a small one is gathered.
class HalvedGrid {
 public:
  // Halves the grid `finer`.
  HalvedGrid(const Workspace& finer, const rc_options& options, int halvings = 1);
  HalvedGrid(HalvedGrid&&) noexcept;
  ~HalvedGrid();

  // Takes over a new surface of the finer grid.
  void renew(const Workspace& finer);
  GridContact& contact() const { return *contact_; }

 private:
  struct Shared;
  void halve_shared(const Workspace& finer, const StepSurface& rows);

  int halvings_;
  CoarseGrid surface_;  // the contact borrows it
  std::unique_ptr<Shared> shared_;
  std::unique_ptr<GridContact> contact_;
};

// The blocks of factor x factor points of a grid that are the cells of a coarser one.
struct Blocks {
  std::int64_t nx = 0, ny = 0;  // of the fine grid
  std::int64_t factor = 1;

  std::int64_t coarse_nx() const { return (nx + factor - 1) / factor; }
  std::int64_t coarse_ny() const { return (ny + factor - 1) / factor; }
  std::int64_t of(std::int64_t point) const { return point / nx / factor * coarse_nx() + point % nx / factor; }
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
