#include "trees/tree_inputs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace rc {

namespace {

constexpr std::int64_t table_side = 64;  // offsets along x and y from which couplings are averaged; extrapolated beyond
constexpr double most_square = 10;       // ratio of sides above which cells or grids are elongated

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

double ratio(double a, double b) { return std::max(a, b) / std::min(a, b); }

// Added to every coefficient of a periodic operator, so that couplings are positive: the mean then deflects like the longest
// wave.
double mean_of(const rc_grid& grid) {
  const double unit = std::sqrt(grid.hx * grid.hy);
  const double lx = grid.hx * static_cast<double>(grid.nx) / unit, ly = grid.hy * static_cast<double>(grid.ny) / unit;
  // More on elongated grids, which have many long waves: the longest alone then misjudges the load's slope.
  const double waves = std::max(lx, ly) > most_square * std::min(lx, ly) ? 3 : 1;
  return waves * grid.softness * std::max(lx, ly) / std::numbers::pi / static_cast<double>(grid.nx * grid.ny);
}

}  // namespace

TreeInputs tree_inputs(const rc_grid& grid, std::int64_t n, const Coefficients& coefficients) {
  CouplingTable table{std::min(grid.nx, table_side), std::min(grid.ny, table_side), {}, grid.hx, grid.hy, 0, 0, 0, 0};
  coefficients(table.mx, table.my, table.k);
  const bool elongated = std::max(ratio(grid.hx, grid.hy), ratio(grid.hx * static_cast<double>(grid.nx),
                                                                 grid.hy * static_cast<double>(grid.ny))) > most_square;
  if (grid.boundary == RC_BOUNDARY_PERIODIC) {
    table.mean = mean_of(grid);
    if (!elongated) {
      table.nx = grid.nx;
      table.ny = grid.ny;
      table.softness = grid.softness;
    }
    for (double& value : table.k) value += table.mean;
  }
  Cells cells = cells_of(grid, n);
  // A single column is treated as a row, because trees take many cells of a row at a time.
  if (cells.full() && cells.mx == 1 && table.mx == 1) {
    std::swap(cells.mx, cells.my);
    std::swap(table.mx, table.my);
    std::swap(table.hx, table.hy);
    std::swap(table.nx, table.ny);
  }
  return {std::move(cells), std::move(table), elongated};
}

}  // namespace rc
