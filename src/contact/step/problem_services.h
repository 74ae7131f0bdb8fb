// Runs of solvers on a bound operator: the services of rc_problem, the warm-up, and solvers inside solvers.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "contact/answer.h"
#include "contact/step/monitor.h"
#include "contact/workspace.h"
#include "operator/operator.h"

namespace rc {

// Whether a run of this solver is without the compenetrations.
bool takes_gap(const rc_solver& solver, const rc_options& options);

// Runs of one solver for one answer: the problem that it sees, and the services behind it.
class SolverRun {
 public:
  // For the answer's choice, on its operator. All three must outlive it.
  SolverRun(Workspace& work, const Answer& answer, Monitor& monitor);

  // Displacement control: w = H p - u, residual relative to 1. Load control: w = H p - u - d, relative to d + max u.
  // p and d: start in, answer out. `approach`: the grid's. u may be empty for a solver that reads the gap.
  // Throws Error for a status < 0.
  rc_status operator()(std::int32_t control, std::span<const double> u, double load, double tol, double approach,
                       std::vector<double>& p, double& d);

  // What the services of rc_problem read.
  Workspace& work;
  const rc_solver& solver;
  const rc_backend& backend;
  Operator& op;
  Monitor& monitor;
  const bool fallbacks;                     // operations that the backend lacks may be replaced
  const rc_grid grid;                       // without its index and approach; gap null: there is no grid
  const double length_unit, pressure_unit;  // of u and p; 0 without a grid
  const std::int64_t most_iterations;       // of each run

  // A remark takes the place of an earlier one that begins with the same words before a colon.
  void note(const std::string& text) const;

 private:
  bool warmed_up_;  // the warm-up runs once, however often the solver does
};

}  // namespace rc
