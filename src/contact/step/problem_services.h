// Runs of solvers on a bound operator: the services of rc_problem, the warm-up, and solvers inside solvers.
#pragma once

#include <functional>
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

struct SolverRun {
  const rc_solver& solver;
  Context& context;
  const rc_options& options;
  const rc_team& team;
  Operator& op;
  Monitor& monitor;
  bool fallbacks;                     // operations that the backend lacks may be replaced
  double lambda_min;                  // a lower bound of the operator's eigenvalues; 0: none
  bool positive;                      // no entry of H is negative
  rc_grid grid;                       // without its index and approach; gap null: there is no grid
  double length_unit, pressure_unit;  // of u and p; 0 without a grid
  std::function<rc_status(rc_coarse&)> coarse;
  std::function<rc_status(std::int64_t mx, std::int64_t my, double* out)> coefficients;
  std::function<void(const std::string&)> note;
  std::int64_t most_iterations;  // of each run
  bool warmed_up = false;        // the warm-up runs once, however often the solver does

  // Displacement control: w = H p - u, residual relative to 1. Load control: w = H p - u - d, relative to d + max u.
  // p and d: start in, answer out. `approach`: the grid's. u may be empty for a solver that reads the gap.
  // Throws Error for a status < 0.
  rc_status operator()(std::int32_t control, std::span<const double> u, double load, double tol, double approach,
                       std::vector<double>& p, double& d);
};

// For the answer's choice on its operator. What is passed must outlive it.
SolverRun solver_run(Workspace& work, const Answer& answer, Monitor& monitor);

}  // namespace rc
