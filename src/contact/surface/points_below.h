// The points of a surface whose gap is below a limit.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "contact/surface/extent.h"
#include "contact/surface/step_surface.h"
#include "operator/operator.h"

namespace rc {

// Included points with gap < limit.
TrialSet points_below(double limit, const StepSurface& surface);
// The same in these tiles, whose numbers are ascending.
TrialSet points_below(double limit, const StepSurface& surface, std::span<const std::int64_t> tiles);
TrialSet included_points(const StepSurface& surface);
Extent extent_below(double limit, const StepSurface& surface);  // of all processes

// The points with gap < limit in one row of tiles of this process, row by row: visit(point, x, y).
template <class Visit> void visit_below(double limit, const StepSurface& surface, std::int64_t tile_row, const Visit& visit) {
  const TileLows& tiles = surface.tiles();
  const std::int64_t columns = tiles.columns(), nx = tiles.nx;
  constexpr std::int64_t tile = TileLows::side;
  for (std::int64_t y = tile_row * tile; y < std::min((tile_row + 1) * tile, tiles.ny); ++y)
    for (std::int64_t column = 0; column < columns; ++column) {
      if (!(tiles.lowest[static_cast<std::size_t>(tile_row * columns + column)] < limit)) continue;
      std::int64_t found[tile], n = 0;  // listed without a branch, which would be foreseen wrongly
      surface.gap().visit([&](const auto* gap) {
        for (std::int64_t x = column * tile; x < std::min((column + 1) * tile, nx); ++x) {
          found[n] = x;
          n += static_cast<double>(gap[y * nx + x]) < limit && surface.included(static_cast<std::size_t>(y * nx + x));
        }
      });
      for (std::int64_t k = 0; k < n; ++k) visit(y * nx + found[k], found[k], y);
    }
}

}  // namespace rc
