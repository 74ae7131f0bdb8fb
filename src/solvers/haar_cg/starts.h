// The start of haar-cg if it gets no pressures, or those of another load.
#pragma once

#include <span>

#include "solvers/haar_cg/iteration/task.h"
#include "solvers/problem.h"
#include "trees/tree_inputs.h"

namespace rc {

// Whether the given pressures are a start: some are positive and, if this solver could begin on half the grid (null: it could
// not), their load is near the one wanted. Of all ranks, if the problem is shared.
bool serves(const Problem& problem, const char* solver, std::span<const double> p);

// The iteration's task for this problem.
HaarTask task_of(const Problem& problem, const TreeInputs& inputs);

// Who solves the coarse grids.
struct CoarseSolver {
  const char* name;             // null: nobody
  bool set_up_is_kept = false;  // for later steps, also of large grids: where setting up takes longer than steps
};

// For pressures that do not serve: p and, by load, d from the solution on half the grid, if there is somebody to solve it.
// If that is also impossible: in load control pressures that carry the load, else none.
void start_haar_cg(const Problem& problem, const CoarseSolver& solver, std::span<double> p, double& d);

}  // namespace rc
