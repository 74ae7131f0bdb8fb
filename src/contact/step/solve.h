// One step on one grid, from the choice of a solver to a certified result.
#pragma once

#include <optional>

#include "contact/memory/memory.h"
#include "contact/proof/result.h"
#include "contact/step/answer.h"
#include "contact/step/monitor.h"
#include "contact/workspace.h"

namespace rc {

// Solves with the first choice of "auto", and with the next where that fails. nearer: the estimate of a coarser grid. Some point
// must touch.
Finished solve_step(Workspace& work, const Memory& memory, const rc_step& step, Monitor& monitor, rc_result& result,
                    std::optional<Estimate> nearer);

}  // namespace rc
