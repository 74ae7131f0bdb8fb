// Accelerated gradient projection: Bemporad & Paggi (2015), Algorithm 4, with the adaptive restart of O'Donoghue & Candes (2015).
//
// Minimises 1/2 p'Hp - u'p over 0 <= p <= cap (load control: and sum p = load) by projected steps of length 1/L, L >=
// lambda_max(H).
#pragma once

#include <limits>

#include "solvers/solver.h"

namespace rc::gradient_projection {

struct Settings {
  double lipschitz = 0;  // L
  bool restart = true;
  std::int64_t steps = std::numeric_limits<std::int64_t>::max();
  bool polls = true;  // false if the steps are part of another solver's iteration
};

// 0 <= p <= cap at every exit. Returns RC_STOP_STALLED if the residual stops falling, or after all steps.
rc_status descend(const Problem& problem, Vector& p, double& d, Settings settings);

}  // namespace rc::gradient_projection
