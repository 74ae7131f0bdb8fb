// One step on one grid, from its target to a certified answer.
#pragma once

#include <optional>

#include "contact/memory/start.h"
#include "contact/problem.h"
#include "contact/proof/certified.h"
#include "contact/target.h"

namespace rc {

struct Solved {
  StepResult result;
  StepOutcome outcome;
};

// Tries sparse contact first, then the whole grid, by the prescribed approach or load. If a component that "auto" chose fails,
// the next one takes over. nearer: the estimate of a coarser grid.
Solved solve_step(const GridProblem& problem, const Memory& memory, const Step& step, Monitor& monitor, const Outputs& outputs,
                  const std::optional<Estimate>& nearer);

}  // namespace rc
