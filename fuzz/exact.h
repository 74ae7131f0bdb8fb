// The exact solution of a small problem in extended precision: 0 <= p <= cap, w = H p - u >= 0 where p = 0, <= 0 where p = cap, 0
// elsewhere.
#pragma once

#include <optional>
#include <vector>

#include "influence.h"

namespace fuzz {

/** By principal pivoting with Murty's rule where blocks do not end (Portugal, Judice & Vicente 1994), each system by a Cholesky
 *  factor. `h` is n x n, symmetric; only points with `open` may carry pressure. Nothing where a factor shows that H is not
 *  positive definite on a set, or no set solves the problem to rounding. */
std::optional<std::vector<Real>> exact_pressures(const std::vector<Real>& h, const std::vector<Real>& u,
                                                 const std::vector<bool>& open, Real cap);

}  // namespace fuzz
