// What haar-cg starts from where it is given no pressures.
#pragma once

#include <span>

#include "solvers/problem.h"

namespace rc {

// Of all ranks, where the problem is shared.
bool any_positive(const Problem& problem, std::span<const double> p);

// For pressures of which none is positive: p and, by load, d from the solution on half the grid by this solver; null: not from
// there. Where that is impossible too, pressures that carry the load in load control; else p stays as it is.
void start_haar_cg(const Problem& problem, const char* solver, std::span<double> p, double& d);

}  // namespace rc
