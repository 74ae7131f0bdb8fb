// Accelerated gradient projection: Bemporad & Paggi (2015), Algorithm 4, with the adaptive restart of O'Donoghue & Candes (2015).
#pragma once

#include "solvers/solver.h"

namespace rc {

// Displacement control: `steps` projected gradient steps on p >= 0.
void gradient_projection(const Problem& problem, Vector& p, int steps);

}  // namespace rc
