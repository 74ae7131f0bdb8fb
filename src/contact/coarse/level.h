// Coarser grids: the systems, surfaces, options and problems on them.
#pragma once

#include <cstdint>
#include <memory>

#include "contact/monitor.h"
#include "contact/problem.h"
#include "grid/downsample.h"

namespace rc {

// The system on nx x ny cells, each `factor` cells wide and high.
rc_system coarser_system(const rc_system& fine, std::int64_t nx, std::int64_t ny, std::int64_t factor);
rc_system halved_system(const rc_system& fine, int halvings);
// Options of a coarser grid: no bounds, and the time that the finest grid has left.
rc_options coarse_options(const rc_options& fine, const Monitor& monitor);

// The surface of half as many points a side, each the mean of 2 x 2; or halved so several times.
CoarseGrid halved(const GridProblem& finer, int halvings);
StepSurface borrowed(const CoarseGrid& grid, const rc_team& team);

// A coarser grid of a step: the problem on a grid that is halved once or several times. If processes gather tiles of the finer
// surface, each halves its own rows, once; a small grid is gathered as a whole.
class Level {
 public:
  Level(const GridProblem& finer, const rc_options& options, int halvings);

  const GridProblem& problem() const { return problem_; }
  int halvings() const { return halvings_; }  // from the finer grid to this one

 private:
  void halve_rows(const GridProblem& finer, const StepSurface& surface);

  const int halvings_;
  CoarseGrid cells_;                         // the problem borrows them
  StepSurface rows_;                         // of this process, if the problem gathers tiles again
  std::unique_ptr<GridProblem> multiplies_;  // with these rows
  GridProblem problem_;
};

}  // namespace rc
