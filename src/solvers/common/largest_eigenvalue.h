// The largest eigenvalue of H from a few products.
#pragma once

#include "solvers/solver.h"

namespace rc {

// A bound from above where H has no negative entry; otherwise an estimate with a margin, which may be too small.
double largest_eigenvalue(const Problem& problem);

// An estimate of the smallest eigenvalue, not below it, from the largest.
double smallest_eigenvalue(const Problem& problem, double largest);

}  // namespace rc
