#include "contact/surface/points_below.h"

#include <utility>
#include <vector>

#include "core/large_memory.h"
#include "core/limits.h"

namespace rc {

namespace {

// Adds the points of row y that are below the limit, in columns begin .. end-1. below(x): whether one is.
template <class Below> void add_below(const Below& below, std::int64_t begin, std::int64_t end, std::int64_t y, Extent& extent) {
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
  surface.points().each(tiles.rows(), [&](std::int64_t row) {
    const double* const lowest = tiles.lowest.data() + row * columns;
    Extent& extent = rows[static_cast<std::size_t>(row)];
    surface.gap().visit([&](const auto* gap) {
      for (std::int64_t y = row * tile; y < std::min((row + 1) * tile, tiles.ny); ++y) {
        const auto* const of_row = gap + y * nx;
        const std::uint8_t* const mask = surface.mask().empty() ? nullptr : surface.mask().data() + y * nx;
        const auto below = [&](std::int64_t x) { return static_cast<double>(of_row[x]) < limit; };
        const auto included_below = [&](std::int64_t x) { return below(x) && mask[x] != 0; };
        for (std::int64_t column = 0; column < columns; ++column) {
          if (!(lowest[column] < limit)) continue;
          const std::int64_t begin = column * tile, end = std::min(begin + tile, nx);
          mask ? add_below(included_below, begin, end, y, extent) : add_below(below, begin, end, y, extent);
        }
      }
    });
  });
  return rows;
}

// The extent over all processes.
Extent united(const std::vector<Extent>& tile_rows, const Rows& rows) {
  Extent extent;
  for (const Extent& row : tile_rows) extent = extent + row;
  if (extent.n > 0) {
    extent.low += rows.first();
    extent.high += rows.first();
  }
  return rows.united(extent);
}

// The points of all processes, whose tiles are held from here on.
TrialSet gathered(const TrialSet& own, const StepSurface& surface) {
  const SurfacePoints& points = surface.own().points();
  std::vector<std::int64_t> mine(static_cast<std::size_t>(own.n));
  for (std::int64_t i = 0; i < own.n; ++i) mine[static_cast<std::size_t>(i)] = own.point(i) + points.rows().first() * points.nx();
  TrialSet all;
  all.index = points.rows().joined(std::move(mine));
  all.n = static_cast<std::int64_t>(all.index.size());
  surface.hold_tiles_of(all.index);
  return all;
}

}  // namespace

Extent extent_below(double limit, const StepSurface& surface) {
  const StepSurface& own = surface.own();
  return united(extents_below(limit, own), own.points().rows());
}

TrialSet points_below(double limit, const StepSurface& surface, std::int64_t most_box) {
  const StepSurface& own = surface.own();
  const SurfacePoints& points = own.points();
  const std::vector<Extent> rows = extents_below(limit, own);
  if (most_box < any_box && united(rows, points.rows()).box() > most_box) return {};
  TrialSet trial;
  std::vector<std::int64_t> begin;
  for (const Extent& row : rows) {
    begin.push_back(trial.n);
    trial.n += row.n;
  }
  if (trial.n < points.count()) {
    trial.index = large_vector<std::int64_t>(static_cast<std::size_t>(trial.n));
    points.each(static_cast<std::int64_t>(rows.size()), [&](std::int64_t row) {
      std::int64_t* to = trial.index.data() + begin[static_cast<std::size_t>(row)];
      own.each_below(limit, row, [&](std::int64_t point, std::int64_t, std::int64_t) { *to++ = point; });
    });
  }
  return surface.gathered() ? gathered(trial, surface) : trial;
}

TrialSet included_points(const StepSurface& surface) { return points_below(infinite, surface); }

}  // namespace rc
