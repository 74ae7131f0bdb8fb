// A step with a prescribed load.
#pragma once

#include <optional>

#include "contact/memory/memory.h"
#include "contact/step/answer.h"
#include "contact/step/monitor.h"
#include "contact/workspace.h"

namespace rc {

// estimate: what a coarser grid tells.
Answer at_load(Workspace& work, const Memory& memory, const rc_step& step, Monitor& monitor, std::optional<Estimate> estimate);

}  // namespace rc
