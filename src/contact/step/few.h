// Solves steps whose contact is at few of the points.
#pragma once

#include <optional>

#include "contact/answer.h"
#include "contact/attempt.h"
#include "contact/memory/memory.h"
#include "contact/problem.h"
#include "contact/target.h"

namespace rc {

// Whether these pressures are at few of the grid's points.
bool at_few(const Pressures& contact, const GridProblem& problem);

// choice: of choose_for_few. Nothing if the estimate has no contact, or one that cannot carry the load.
std::optional<Answer> solve_few(const GridProblem& problem, const Memory& memory, const Step& step, const Choice& choice,
                                Estimate estimate, Attempt& attempt);

}  // namespace rc
