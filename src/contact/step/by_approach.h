// A step with a prescribed approach.
#pragma once

#include <optional>

#include "contact/answer.h"
#include "contact/attempt.h"
#include "contact/memory/memory.h"
#include "contact/problem.h"
#include "contact/target.h"

namespace rc {

// nearer: the estimate of a coarser grid.
Answer at_approach(const GridProblem& problem, const Memory& memory, const Step& step, const Attempt& attempt,
                   const std::optional<Estimate>& nearer);

}  // namespace rc
