#include "solvers/haar_planting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rc {

namespace {

constexpr std::int64_t table_side = 64;  // couplings are averaged from this many offsets, and extrapolated beyond
constexpr double elongated = 10;         // ratio of a periodic surface's sides

// The unknowns in their bounding box.
Cells cells_of(const rc_grid& grid, std::int64_t n) {
  if (!grid.index) return {grid.nx, grid.ny, {}, {}};
  Cells cells{0, 0, std::vector<std::int32_t>(static_cast<std::size_t>(n)),
              std::vector<std::int32_t>(static_cast<std::size_t>(n))};
  std::int32_t left = std::numeric_limits<std::int32_t>::max(), right = 0;
  for (std::size_t i = 0; i < cells.x.size(); ++i) {
    cells.x[i] = static_cast<std::int32_t>(grid.index[i] % grid.nx);
    cells.y[i] = static_cast<std::int32_t>(grid.index[i] / grid.nx);
    left = std::min(left, cells.x[i]);
    right = std::max(right, cells.x[i]);
  }
  const std::int32_t low = cells.y.front(), high = cells.y.back();
  cells.mx = right - left + 1;
  cells.my = high - low + 1;
  if (cells.mx * cells.my == n) return {cells.mx, cells.my, {}, {}};
  for (std::int32_t& x : cells.x) x -= left;
  for (std::int32_t& y : cells.y) y -= low;
  return cells;
}

// The mean of the periodic operator counts as its longest wave, so that the couplings are positive.
double mean_of(const rc_grid& grid) {
  const double unit = std::sqrt(grid.hx * grid.hy);
  const double longest = std::max(grid.hx * static_cast<double>(grid.nx), grid.hy * static_cast<double>(grid.ny)) / unit;
  const double shortest = std::min(grid.hx * static_cast<double>(grid.nx), grid.hy * static_cast<double>(grid.ny)) / unit;
  // More where many waves are long: then the longest alone tells too little of the load's slope.
  const double waves = longest > elongated * shortest ? 3 : 1;
  return waves * longest / std::numbers::pi / static_cast<double>(grid.nx * grid.ny);
}

}  // namespace

Planting planting_on(const rc_grid& grid, std::int64_t n, const Coefficients& coefficients) {
  CouplingTable table{std::min(grid.nx, table_side), std::min(grid.ny, table_side), {}, grid.hx, grid.hy};
  coefficients(table.mx, table.my, table.k);
  const double mean = grid.boundary == RC_BOUNDARY_PERIODIC ? mean_of(grid) : 0;
  if (mean > 0)
    for (double& value : table.k) value += mean;
  return {cells_of(grid, n), std::move(table), mean};
}

}  // namespace rc
