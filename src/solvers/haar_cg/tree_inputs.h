// What the trees over a grid's unknowns are planted from.
#pragma once

#include <roughcontact/plugin.h>

#include <cstdint>
#include <functional>
#include <vector>

#include "solvers/haar_cg/tree.h"

namespace rc {

struct TreeInputs {
  Cells cells;
  CouplingTable table;
  double mean = 0;         // periodic: what was added to every coefficient of the table
  bool elongated = false;  // cells or sides differ so much that the trees may misjudge the slope of the load by far
};

// Coefficients at the offsets (ix, iy), 0 <= ix < mx, 0 <= iy < my.
using Coefficients = std::function<void(std::int64_t mx, std::int64_t my, std::vector<double>& out)>;

// n: number of unknowns.
TreeInputs tree_inputs(const rc_grid& grid, std::int64_t n, const Coefficients& coefficients);

}  // namespace rc
