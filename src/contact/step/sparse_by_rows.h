// Sparse contact of processes that share the grid by rows: each has the gap of its rows and screens them; the tiles where the
// contact is are gathered, and every process solves there alike what a single one would. With periodic boundaries they make each
// product together.
#pragma once

#include <optional>

#include "contact/memory/start.h"
#include "contact/problem.h"
#include "contact/proof/certified.h"

namespace rc {

// Nothing if the process is alone, contact is not sparse, or the options leave no backend for it. The pressures are those
// of this process's rows.
std::optional<Finished> sparse_by_rows(const GridProblem& problem, const Memory& memory, const Step& step, const Attempt& attempt,
                                       const Outputs& outputs);

}  // namespace rc
