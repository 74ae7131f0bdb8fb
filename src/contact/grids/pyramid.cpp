#include "contact/grids/pyramid.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <roughcontact/plugin.hpp>
#include <utility>
#include <vector>

#include "contact/grid_contact.h"
#include "contact/step/monitor.h"
#include "contact/workspace.h"

namespace rc {

namespace {

CoarseGrid coarser(const Workspace& finer, int halvings) {
  return downsample(finer.system.given.nx, finer.system.given.ny, finer.surface.gap(), finer.surface.masks(), halvings,
                    [&](std::int64_t rows, const std::function<void(std::int64_t)>& act) {
                      roughcontact::for_each(finer.team(), rows, true, [&](std::int64_t row, std::int64_t) { act(row); });
                    });
}

StepSurface borrowed(const CoarseGrid& grid, const rc_team& team) {
  return StepSurface({grid.nx, grid.ny, grid.gap, grid.mask, true}, team);
}

// act(point) for every included point of a block.
template <class Act> void each_point(const Blocks& blocks, std::int64_t block, const StepSurface& fine, Act&& act) {
  const std::int64_t x = block % blocks.coarse_nx() * blocks.factor, y = block / blocks.coarse_nx() * blocks.factor;
  for (std::int64_t iy = y; iy < std::min(y + blocks.factor, blocks.ny); ++iy)
    for (std::int64_t ix = x; ix < std::min(x + blocks.factor, blocks.nx); ++ix)
      if (fine.included(static_cast<std::size_t>(iy * blocks.nx + ix))) act(iy * blocks.nx + ix);
}

}  // namespace

rc_system coarser_system(const rc_system& fine, std::int64_t nx, std::int64_t ny, std::int64_t factor) {
  rc_system system = fine;
  system.nx = nx;
  system.ny = ny;
  system.hx *= static_cast<double>(factor);
  system.hy *= static_cast<double>(factor);
  return system;
}

rc_options coarse_options(const rc_options& fine, const Monitor& monitor) {
  rc_options options = fine;
  options.set(RC_OPT_BOUNDS, std::int64_t{0});
  options.set(RC_OPT_TIME_LIMIT, monitor.time_left());
  return options;
}

// The rows of a rank on the coarser grid, of which tiles are gathered again.
struct HalvedGrid::Shared {
  Ranks ranks;
  StepSurface rows{};
  std::unique_ptr<Workspace> multiplies{};  // with them
};

HalvedGrid::HalvedGrid(const Workspace& finer, const rc_options& options, int halvings) : halvings_(halvings) {
  const GatheredTiles* const tiles = finer.surface.tiles();
  const rc_system& system = finer.system.given;
  const std::int64_t side = std::int64_t{1} << halvings, nx = (system.nx + side - 1) / side, ny = (system.ny + side - 1) / side;
  contact_ = std::make_unique<GridContact>(coarser_system(system, nx, ny, side), options, &finer.team());
  contact_->work().do_alike(finer.alike());
  if (tiles) {
    halve_shared(finer, tiles->shared());
    return;
  }
  surface_ = coarser(finer, halvings);
  contact_->adopt(borrowed(surface_, finer.team()));
}

void HalvedGrid::halve_shared(const Workspace& finer, const StepSurface& rows) {
  constexpr std::int64_t most_gathered = 512 * 512;  // points
  const Ranks& ranks = *rows.ranks();
  shared_.reset(new Shared{ranks.halved()});
  surface_ = downsample(rows.nx(), ranks.rows(), rows.gap(), rows.masks(), Filter::mean);
  const std::int64_t ny = shared_->ranks.all_rows();
  if (surface_.nx * ny >= most_gathered && ranks.halvings() > 1) {
    shared_->rows = StepSurface({surface_.nx, surface_.ny, surface_.gap, surface_.mask, true}, finer.team(), &shared_->ranks);
    if (finer.rows()) {
      Workspace& work = contact_->work();
      shared_->multiplies = std::make_unique<Workspace>(work.system.given, work.options, &finer.team(), &shared_->ranks);
      work.multiply_by(shared_->multiplies.get());
    }
    return contact_->adopt(StepSurface(shared_->rows, finer.team()));
  }
  surface_.gap = ranks.of_any(surface_.gap);
  surface_.mask = ranks.of_any(surface_.mask);
  surface_.ny = ny;
  contact_->adopt(borrowed(surface_, finer.team()));
}

HalvedGrid::HalvedGrid(HalvedGrid&&) noexcept = default;
HalvedGrid::~HalvedGrid() = default;

void HalvedGrid::renew(const Workspace& finer) {
  CoarseGrid next = coarser(finer, halvings_);
  contact_->adopt(borrowed(next, finer.team()));
  surface_ = std::move(next);
}

std::int64_t Blocks::included(std::int64_t block, const StepSurface& fine) const {
  std::int64_t count = 0;
  each_point(*this, block, fine, [&](std::int64_t) { ++count; });
  return count;
}

// Blocks come row by row, and points go out row by row.
Pressures spread(const Pressures& coarse, const Blocks& blocks, const StepSurface& fine, Cut cut) {
  Pressures result;
  const auto loaded = std::count_if(coarse.p.begin(), coarse.p.end(), [](double p) { return p > 0; });
  const auto room = static_cast<std::size_t>(loaded * blocks.factor * blocks.factor);
  result.on.index.reserve(room);
  result.p.reserve(room);
  std::vector<std::pair<std::int64_t, double>> row;  // first column and pressure of blocks side by side
  for (std::size_t k = 0; k < coarse.p.size();) {
    const std::int64_t y = coarse.on.point(static_cast<std::int64_t>(k)) / blocks.coarse_nx();
    row.clear();
    for (; k < coarse.p.size(); ++k) {
      const std::int64_t block = coarse.on.point(static_cast<std::int64_t>(k));
      if (block / blocks.coarse_nx() != y) break;
      double p = coarse.p[k];
      if (!(p > 0)) continue;
      if (cut == Cut::same_force)
        p *= static_cast<double>(blocks.factor * blocks.factor) / static_cast<double>(blocks.included(block, fine));
      row.emplace_back(block % blocks.coarse_nx() * blocks.factor, p);
    }
    for (std::int64_t iy = y * blocks.factor; iy < std::min((y + 1) * blocks.factor, blocks.ny); ++iy)
      for (const auto& [x, p] : row)
        for (std::int64_t point = iy * blocks.nx + x; point < iy * blocks.nx + std::min(x + blocks.factor, blocks.nx); ++point) {
          if (!fine.included(static_cast<std::size_t>(point))) continue;
          result.on.index.push_back(point);
          result.p.push_back(p);
        }
  }
  result.on.n = static_cast<std::int64_t>(result.p.size());
  if (result.on.n == blocks.nx * blocks.ny) result.on.index.clear();
  return result;
}

double left_out(const Pressures& p, const Blocks& blocks, const StepSurface& fine, const GapValues& coarse_gap) {
  double sum = 0, largest = 0;
  std::int64_t count = 0;
  for (std::size_t k = 0; k < p.p.size(); ++k) {
    if (!(p.p[k] > 0)) continue;
    const std::int64_t point = p.on.point(static_cast<std::int64_t>(k));
    const double detail = fine.gap()[static_cast<std::size_t>(point)] - coarse_gap[static_cast<std::size_t>(blocks.of(point))];
    // Squares are summed in units of the largest detail, so that they stay within double precision.
    if (const double size = std::abs(detail); size > largest) {
      sum *= (largest / size) * (largest / size);
      largest = size;
    }
    if (largest > 0) sum += (detail / largest) * (detail / largest);
    ++count;
  }
  return count > 0 ? largest * std::sqrt(sum / static_cast<double>(count)) : 0;
}

}  // namespace rc
