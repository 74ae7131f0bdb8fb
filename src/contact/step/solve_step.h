// One step on one grid, from the choice of a solver to a certified result.
#pragma once

#include <optional>

#include "contact/answer.h"
#include "contact/memory.h"
#include "contact/step/certified_result.h"
#include "contact/step/monitor.h"
#include "contact/workspace.h"

namespace rc {

// Solves with what "auto" chooses first, and goes on to its next choice where that fails. nearer: what a coarser grid tells.
// Some point touches.
Finished solve_step(Workspace& work, const Memory& memory, const rc_step& step, Monitor& monitor, rc_result& result,
                    std::optional<Estimate> nearer);

}  // namespace rc
