// The extreme eigenvalues of H, estimated from a few products.
#pragma once

#include "solvers/solver.h"

namespace rc {

// An upper bound where H has no negative entry. Otherwise an estimate with a margin, which may still be too small.
double largest_eigenvalue(const Problem& problem);

// An estimate of the smallest eigenvalue. largest: what largest_eigenvalue returned.
double smallest_eigenvalue(const Problem& problem, double largest);

}  // namespace rc
