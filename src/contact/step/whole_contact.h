// Contact anywhere: the trial set has every point that can touch at the approach.
#pragma once

#include <optional>

#include "contact/answer.h"
#include "contact/attempt.h"
#include "contact/memory/start.h"
#include "contact/problem.h"
#include "contact/target.h"

namespace rc {

// estimate: that of a coarser grid, to start from instead.
Answer whole_contact(const GridProblem& problem, const Target& target, const Start& start, const Attempt& attempt,
                     std::optional<Estimate> estimate);

}  // namespace rc
