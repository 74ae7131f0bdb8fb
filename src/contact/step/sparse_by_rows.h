// Sparse contact of processes that share the grid by rows: each has the gap of its rows and screens them; the tiles where the
// contact is are gathered, and every process solves there what a single one would. With periodic boundaries they make each
// product together.
#pragma once

#include <optional>

#include "contact/memory/start.h"
#include "contact/problem.h"
#include "contact/proof/certified.h"

namespace rc {

// few: of choose_for_few. Nothing if contact is not sparse, or a process lacks these components. The pressures are those of this
// process's rows.
std::optional<StepResult> sparse_by_rows(const GridProblem& problem, const Target& target, const Start& start,
                                         const std::optional<Choice>& few, const Attempt& attempt, const Outputs& outputs);

}  // namespace rc
