// The input of the trees over a grid's unknowns: couplings, and where the unknowns lie.
#pragma once

#include <roughcontact/plugin.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace rc {

// Influence coefficients at small offsets. Couplings of neighbours on every level follow from them and, on a periodic surface,
// from its softness.
struct CouplingTable {
  std::int64_t mx, my;
  std::vector<double> k;  // [iy*mx + ix]
  double hx, hy;          // cell size
  // Periodic surfaces: cells of a period, the dimensionless 1/E*, and the mean that was added to every coefficient.
  std::int64_t nx = 0, ny = 0;
  double softness = 0, mean = 0;
};

// The cells of the unknowns: all cells of a box, or some of them.
struct Cells {
  std::int64_t mx, my;
  std::vector<std::int32_t> x, y;  // of each unknown, rows in ascending order; empty: every cell

  bool full() const { return x.empty(); }
};

struct TreeInputs {
  Cells cells;
  CouplingTable table;
  bool elongated = false;  // cells or grid are elongated: the trees may misjudge the load's slope by far
};

// Coefficients at the offsets (ix, iy), 0 <= ix < mx, 0 <= iy < my.
using Coefficients = std::function<void(std::int64_t mx, std::int64_t my, std::vector<double>& out)>;

// n: number of unknowns.
TreeInputs tree_inputs(const rc_grid& grid, std::int64_t n, const Coefficients& coefficients);

}  // namespace rc
