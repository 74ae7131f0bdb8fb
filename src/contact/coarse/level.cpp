#include "contact/coarse/level.h"

#include <functional>
#include <roughcontact/plugin.hpp>
#include <utility>

#include "contact/operators.h"

namespace rc {

CoarseGrid halved(const GridProblem& finer, int halvings) {
  return downsample(finer.system.given.nx, finer.system.given.ny, finer.surface.gap(), finer.surface.mask(), halvings,
                    [&](std::int64_t rows, const std::function<void(std::int64_t)>& act) {
                      roughcontact::for_each(finer.team(), rows, true, [&](std::int64_t row, std::int64_t) { act(row); });
                    });
}

StepSurface borrowed(const CoarseGrid& grid, const rc_team& team) {
  return StepSurface({grid.nx, grid.ny, grid.gap, grid.mask, true}, team);
}

rc_system coarser_system(const rc_system& fine, std::int64_t nx, std::int64_t ny, std::int64_t factor) {
  rc_system system = fine;
  system.nx = nx;
  system.ny = ny;
  system.hx *= static_cast<double>(factor);
  system.hy *= static_cast<double>(factor);
  return system;
}

rc_system halved_system(const rc_system& fine, int halvings) {
  const std::int64_t side = std::int64_t{1} << halvings;
  return coarser_system(fine, (fine.nx + side - 1) / side, (fine.ny + side - 1) / side, side);
}

rc_options coarse_options(const rc_options& fine, const Monitor& monitor) {
  rc_options options = fine;
  options.set(RC_OPT_BOUNDS, std::int64_t{0});
  options.set(RC_OPT_TIME_LIMIT, monitor.time_left());
  return options;
}

Level::Level(const GridProblem& finer, const rc_options& options, int halvings)
    : halvings_(halvings), problem_(halved_system(finer.system.given, halvings), options, &finer.team(), finer.company()) {
  if (const GatheredTiles* const gathered = finer.surface.gathered()) {
    halve_rows(finer, gathered->shared());
    return;
  }
  cells_ = halved(finer, halvings);
  problem_.surface = borrowed(cells_, finer.team());
}

void Level::halve_rows(const GridProblem& finer, const StepSurface& surface) {
  constexpr std::int64_t most_gathered = 512 * 512;  // points
  const Rows &own = surface.points().rows(), half = own.halved();
  cells_ = downsample(surface.points().nx(), own.own(0), surface.gap(), surface.mask(), Filter::mean);
  const std::int64_t ny = half.all(0);
  if (cells_.nx * ny >= most_gathered && own.halvings() > 1) {
    rows_ = StepSurface({cells_.nx, cells_.ny, cells_.gap, cells_.mask, true}, finer.team(), half);
    if (finer.operators().multiply_by_rows()) {
      multiplies_ = std::make_unique<GridProblem>(problem_.system.given, problem_.options, &finer.team(), Company(half));
      problem_.operators().multiply_by(multiplies_->operators());
    }
    problem_.surface = StepSurface(rows_, finer.team());
    return;
  }
  cells_.gap = own.joined(std::move(cells_.gap));
  cells_.mask = own.joined(std::move(cells_.mask));
  cells_.ny = ny;
  problem_.surface = borrowed(cells_, finer.team());
}

}  // namespace rc
