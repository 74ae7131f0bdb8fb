// A step with a prescribed load.
#pragma once

#include <optional>

#include "contact/answer.h"
#include "contact/attempt.h"
#include "contact/memory/memory.h"
#include "contact/problem.h"
#include "contact/target.h"

namespace rc {

// estimate: that of a coarser grid.
Answer at_load(const GridProblem& problem, const Memory& memory, const Step& step, const Attempt& attempt,
               std::optional<Estimate> estimate);

}  // namespace rc
