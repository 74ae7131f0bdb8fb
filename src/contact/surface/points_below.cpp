#include "contact/surface/points_below.h"

#include <roughcontact/plugin.hpp>
#include <utility>
#include <vector>

#include "core/large_memory.h"
#include "core/limits.h"

namespace rc {

namespace {

// Adds the points with gap < limit in columns begin .. end-1 of row y. gap: of that row.
template <class Value>
void add_below(double limit, const Value* gap, std::int64_t begin, std::int64_t end, std::int64_t y, Extent& extent) {
  const auto below = [&](std::int64_t x) { return static_cast<double>(gap[x]) < limit; };
  std::int64_t n = 0;
  for (std::int64_t x = begin; x < end; ++x) n += below(x);
  if (n == 0) return;
  std::int64_t left = begin, right = end - 1;  // looked for where they widen the extent
  while (left < extent.left && !below(left)) ++left;
  while (right > extent.right && !below(right)) --right;
  extent = extent + Extent{n, left, right, y, y};
}

// One for each row of tiles of this process.
std::vector<Extent> extents_below(double limit, const StepSurface& surface) {
  constexpr std::int64_t tile = TileLows::side;
  const TileLows& tiles = surface.tiles();
  const std::int64_t columns = tiles.columns(), nx = tiles.nx;
  std::vector<Extent> rows(static_cast<std::size_t>(tiles.rows()));
  const auto unmasked = [&](std::int64_t row, Extent& extent) {
    surface.gap().visit([&](const auto* gap) {
      for (std::int64_t y = row * tile; y < std::min((row + 1) * tile, tiles.ny); ++y)
        for (std::int64_t column = 0; column < columns; ++column)
          if (tiles.lowest[static_cast<std::size_t>(row * columns + column)] < limit)
            add_below(limit, gap + y * nx, column * tile, std::min((column + 1) * tile, nx), y, extent);
    });
  };
  const SurfacePoints& points = surface.points();
  roughcontact::for_each(points.team(), tiles.rows(), points.threaded(), [&](std::int64_t row, std::int64_t) {
    Extent& extent = rows[static_cast<std::size_t>(row)];
    if (surface.mask().empty()) return unmasked(row, extent);
    visit_below(limit, surface, row, [&](std::int64_t, std::int64_t x, std::int64_t y) { extent.add(x, y); });
  });
  return rows;
}

}  // namespace

Extent extent_below(double limit, const StepSurface& surface) {
  if (const GatheredTiles* const gathered = surface.gathered()) return extent_below(limit, gathered->shared());
  const Rows& rows = surface.points().rows();
  Extent extent;
  for (const Extent& row : extents_below(limit, surface)) extent = extent + row;
  if (extent.n > 0) {
    extent.low += rows.first();
    extent.high += rows.first();
  }
  return rows.united(extent);
}

TrialSet points_below(double limit, const StepSurface& surface) {
  TrialSet trial;
  if (GatheredTiles* const gathered = surface.gathered()) {
    const StepSurface& shared = gathered->shared();
    const Rows& rows = shared.points().rows();
    const TrialSet own = points_below(limit, shared);
    std::vector<std::int64_t> mine(static_cast<std::size_t>(own.n));
    for (std::int64_t i = 0; i < own.n; ++i)
      mine[static_cast<std::size_t>(i)] = own.point(i) + rows.first() * shared.points().nx();
    trial.index = rows.joined(std::move(mine));
    trial.n = static_cast<std::int64_t>(trial.index.size());
    gathered->hold_tiles_of(trial.index);
    return trial;
  }
  const std::vector<Extent> rows = extents_below(limit, surface);
  const SurfacePoints& points = surface.points();
  std::vector<std::int64_t> begin;
  for (const Extent& row : rows) {
    begin.push_back(trial.n);
    trial.n += row.n;
  }
  if (trial.n == points.count()) return trial;
  trial.index = large_vector<std::int64_t>(static_cast<std::size_t>(trial.n));
  const auto n_rows = static_cast<std::int64_t>(rows.size());
  roughcontact::for_each(points.team(), n_rows, points.threaded(), [&](std::int64_t row, std::int64_t) {
    std::int64_t* to = trial.index.data() + begin[static_cast<std::size_t>(row)];
    visit_below(limit, surface, row, [&](std::int64_t point, std::int64_t, std::int64_t) { *to++ = point; });
  });
  return trial;
}

TrialSet points_below(double limit, const StepSurface& surface, std::span<const std::int64_t> tiles) {
  TrialSet trial;
  if (GatheredTiles* const gathered = surface.gathered()) gathered->hold(tiles);
  for (const std::int64_t each : tiles)
    surface.tiles().each_point(each, [&](std::int64_t point) {
      if (surface.included(static_cast<std::size_t>(point)) && surface.gap_at(static_cast<std::size_t>(point)) < limit)
        trial.index.push_back(point);
    });
  std::sort(trial.index.begin(), trial.index.end());
  trial.n = static_cast<std::int64_t>(trial.index.size());
  if (trial.n == surface.points().count()) trial.index.clear();
  return trial;
}

TrialSet included_points(const StepSurface& surface) { return points_below(infinite, surface); }

}  // namespace rc
