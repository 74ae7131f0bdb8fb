#include "contact/step/by_approach.h"

#include "contact/step/trial.h"

namespace rc {

Answer at_approach(const GridProblem& problem, const Memory& memory, const Step& step, const Attempt& attempt,
                   const std::optional<Estimate>& nearer) {
  const double approach = step.target.value, depth = step.target.compression(problem.surface);
  Trial trial(problem, step, trial_below(approach, problem), depth, attempt);
  trial.bind();
  trial.start(memory, step, nearer ? &nearer->pressures : nullptr);
  trial.continue_from(memory, step, !nearer);
  trial.answer.compression = trial.answer.limit = depth;
  double unused = 0;
  trial.solve(0, solver_tol(problem) * (residual_scale(step.target, problem, depth) / depth), approach, unused);
  return std::move(trial.answer);
}

}  // namespace rc
