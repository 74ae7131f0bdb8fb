// Derivatives of a certified step. C is the set of its points with p > 0; h the undeformed gap, u = d - h, a the area of a cell,
// s = H_CC^-1 1 on C and 0 elsewhere.
//
// Reverse mode, J(p, g, load, d): lambda = H_CC^-1 (dJ/dp + H dJ/dg)_C on C, 0 elsewhere. Approach control, w = lambda:
// dJ/dd = sum(w - dJ/dg), dJ/dh = dJ/dg - w. Load control, w = lambda - s sum(lambda - dJ/dg) / sum(s): dJ/dload =
// sum(lambda - dJ/dg) / (a sum(s)), dJ/dh = dJ/dg - w. Since H is proportional to 1/E*, E* dJ/dE* = w'u_C - (dJ/dg)'H p.
// Forward mode: dp_C = H_CC^-1 (dd - dh + u dE*/E*)_C, in load control with the dd at which a sum(dp) is the change of the load.
#pragma once

#include <roughcontact/derivatives.h>

#include "contact/memory/memory.h"
#include "contact/monitor.h"
#include "contact/problem.h"

namespace rc {

// Write the outputs of the request at their ends. Throw Error(ARGUMENT) if the last step has no derivatives.
rc_status differentiate(const GridProblem& problem, const Memory& memory, const Monitor& monitor, rc_gradient& request);
rc_status differentiate(const GridProblem& problem, const Memory& memory, const Monitor& monitor, rc_tangent& request);

}  // namespace rc
