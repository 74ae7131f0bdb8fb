// Solves steps whose contact is far sparser than the grid.
#pragma once

#include <optional>

#include "contact/memory/memory.h"
#include "contact/step/answer.h"
#include "contact/step/monitor.h"
#include "contact/workspace.h"

namespace rc {

// Nothing where contact is not sparse, or the options leave no backend that screens. estimate: that of a coarser grid, or
// nothing; a step that starts from nothing then gets what a coarser grid told before it gave up.
std::optional<Answer> sparse_contact(Workspace& work, const Memory& memory, const rc_step& step, Monitor& monitor,
                                     std::optional<Estimate>& estimate);

}  // namespace rc
