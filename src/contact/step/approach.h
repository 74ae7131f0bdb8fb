// Solves a step with a prescribed approach.
#pragma once

#include <optional>

#include "contact/memory/memory.h"
#include "contact/step/answer.h"
#include "contact/step/monitor.h"
#include "contact/workspace.h"

namespace rc {

// nearer: the estimate of a coarser grid.
Answer at_approach(Workspace& work, const Memory& memory, const rc_step& step, Monitor& monitor,
                   std::optional<Estimate> nearer = std::nullopt);

}  // namespace rc
