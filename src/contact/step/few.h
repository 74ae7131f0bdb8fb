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

// The components for a step at few points. Nothing if processes share it by rows, it gives its own start, the grid is small, or
// the options leave no backend for it.
std::optional<Choice> choose_few(const GridProblem& problem, const Step& step);

// choice: of choose_few. Nothing if the estimate has no contact, or one that cannot carry the load.
std::optional<Answer> solve_few(const GridProblem& problem, const Memory& memory, const Step& step, const Choice& choice,
                                Estimate estimate, const Attempt& attempt);

// From the estimate of an accuracy goal's coarser grid. Also nothing if contact there is not at few points.
std::optional<Answer> solve_if_few(const GridProblem& problem, const Memory& memory, const Step& step, const Estimate& nearer,
                                   const Attempt& attempt);

}  // namespace rc
