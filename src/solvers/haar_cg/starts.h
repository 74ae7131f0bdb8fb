// What haar-cg starts from where it is given no pressures, or those of another load.
#pragma once

#include <span>

#include "solvers/problem.h"

namespace rc {

// Of all ranks, where the problem is shared.
bool any_positive(const Problem& problem, std::span<const double> p);

// Where no pressure is positive, or they carry a load far from the prescribed one: p and, by load, d from the solution on half the
// grid by this solver; null: not from there. Where all are 0 even then: in load control pressures that carry the load; else p
// stays as it is.
void start_haar_cg(const Problem& problem, const char* solver, std::span<double> p, double& d);

}  // namespace rc
