// Starts for surfaces so regular that plain steps solve them: a few waves that are pressed flat on a periodic surface, or two
// heights of which the upper ones carry the load.
#pragma once

#include <span>

#include "solvers/solver.h"

namespace rc {

// Pressures of such a surface, after a few products; false where it is none, or its contact is another: p is then as it was.
bool start_regular(const Problem& problem, std::span<double> p);

}  // namespace rc
