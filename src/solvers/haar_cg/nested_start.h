// A start from the solution on a grid of half the resolution. That solution starts from a still coarser grid.
#pragma once

#include <span>

#include "solvers/solver.h"

namespace rc {

// Leaves p and d as they are where the grid is too small, or its coarse problem cannot be solved.
void start_nested(const Problem& problem, std::span<double> p, double& d);

}  // namespace rc
