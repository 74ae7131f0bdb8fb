// Sparse contact of ranks that share the grid by rows: each has the gap of its rows and screens them; the tiles where the contact
// is are gathered, and every rank solves there alike what a single process would. With periodic boundaries ranks make each
// product together.
#pragma once

#include <optional>

#include "contact/memory/memory.h"
#include "contact/proof/result.h"
#include "contact/step/monitor.h"
#include "contact/workspace.h"

namespace rc {

// Nothing where no ranks share the grid, contact is not sparse, or the options leave no backend for it. The pressures are those
// of this rank's rows.
std::optional<Finished> shared_sparse_contact(Workspace& work, const Memory& memory, const rc_step& step, Monitor& monitor,
                                              rc_result& result);

}  // namespace rc
