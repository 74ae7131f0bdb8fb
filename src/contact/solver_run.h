// One call of a solver on a bound operator.
#pragma once

#include <span>
#include <vector>

#include "contact/monitor.h"
#include "operator/operator.h"

namespace rc {

struct SolverRun {
  const rc_solver& solver;
  const Context& context;
  const rc_options& options;
  Operator& op;
  Monitor& monitor;
  bool fallbacks;  // systems on subsets may be solved by iteration

  // Displacement control: w = H p - u, residual relative to 1. Load control: w = H p - u - d, relative to d + max u.
  // p and d: start in, answer out. Throws Error for a status < 0.
  rc_status operator()(std::int32_t control, std::span<const double> u, double load, double tol, std::vector<double>& p,
                       double& d) const;
};

}  // namespace rc
