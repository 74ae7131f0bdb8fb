// The exact solution of a small problem: p >= 0, w = H p - u >= 0, p w = 0, in extended precision.
#pragma once

#include <optional>
#include <vector>

#include "influence.h"

namespace fuzz {

/** By principal pivoting with Murty's rule where blocks do not end (Portugal, Judice & Vicente 1994), each system by a Cholesky
 *  factor. `h` is n x n, symmetric; only points with `open` may carry pressure. Nothing where a factor shows that H is not
 *  positive definite on a set, or no set solves the problem to rounding. */
std::optional<std::vector<Real>> exact_pressures(const std::vector<Real>& h, const std::vector<Real>& u,
                                                 const std::vector<bool>& open);

}  // namespace fuzz
