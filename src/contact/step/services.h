// Runs of solvers on a bound operator: the services of rc_problem, the warm-up, and solvers inside solvers.
#pragma once

#include <span>
#include <vector>

#include "contact/answer.h"
#include "contact/attempt.h"
#include "contact/problem.h"
#include "operator/operator.h"

namespace rc {

// Whether this solver reads the gap and no other one warms up, so that the run needs no penetrations.
bool takes_gap(const rc_solver& solver, const rc_options& options);

struct BoundProblem;

// Runs one solver for one answer. It makes the solver's problem and its services.
class SolverRun {
 public:
  // Runs the solver of answer.choice on answer.op; its remarks go to the answer. history: null, or what the first run's start was
  // made of, with room for what its solver keeps of its answer. All must outlive it.
  SolverRun(const GridProblem& problem, Answer& answer, const Attempt& attempt, KeptSteps* history = nullptr);

  // Approach control: w = H p - u, residual relative to 1. Load control: w = H p - u - d, relative to d + max u.
  // p and d: start in, answer out. `approach`: the grid's. u may be empty for a solver that reads the gap.
  // Throws Error for a status < 0.
  rc_status operator()(std::int32_t control, std::span<const double> u, double load, double tol, double approach,
                       std::vector<double>& p, double& d);

  // Members that the services of rc_problem read.
  const GridProblem& problem;
  const Choice choice;
  Operator& op;
  const Attempt& attempt;
  Remarks& remarks;
  const bool fallbacks;                     // operations that the backend lacks may be replaced
  const rc_grid grid;                       // without its index, approach and gap; nx = 0: there is none
  const double length_unit, pressure_unit;  // of u and p; 0 without a grid
  const double cap;                         // the largest p
  const std::int64_t most_iterations;       // of each run

  // A step's problem and the problems that its solver opens inside it take turns on the operator. owner: the one it is bound to.
  const BoundProblem* owner = nullptr;

 private:
  KeptSteps* history_;
  bool warmed_up_;  // the warm-up runs once, however often the solver does
};

}  // namespace rc
