// Solves steps whose contact is far sparser than the grid.
#pragma once

#include <optional>

#include "contact/answer.h"
#include "contact/attempt.h"
#include "contact/memory/memory.h"
#include "contact/problem.h"
#include "contact/target.h"

namespace rc {

// Nothing if contact is not sparse, or the options leave no backend that screens. estimate: that of a coarser grid, or
// nothing; a step without a start then gets the pressures that a coarser grid had found before it gave up.
std::optional<Answer> sparse_contact(const GridProblem& problem, const Memory& memory, const Step& step, Attempt& attempt,
                                     std::optional<Estimate>& estimate);

}  // namespace rc
