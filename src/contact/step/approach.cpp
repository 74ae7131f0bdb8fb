#include "contact/step/approach.h"

#include <utility>

#include "contact/step/services.h"
#include "contact/step/target.h"
#include "contact/step/trial_set.h"

namespace rc {

Answer at_approach(Workspace& work, const Memory& memory, const rc_step& step, Monitor& monitor, std::optional<Estimate> nearer) {
  TrialSet trial = trial_below(step.target, work);
  const double depth = compression_of(step, work);
  Answer answer = prepared(trial, step.control, depth, work);
  trial = widened(std::move(trial), answer.choice, work);
  answer.op = &work.bound_operator(*answer.choice.backend, trial);
  on_all(work.ranks(), [&] {
    answer.p = memory.start(step, trial, answer.pressure_unit, answer.cap(), nearer ? &nearer->pressures : nullptr, work.team());
  });
  if (!nearer) answer.history = memory.history(step);
  nearer.reset();
  if (work.options.integer(RC_OPT_STIFFNESS) != 0) answer.before = memory.earlier(step, trial);
  answer.compression = answer.limit = depth;
  const std::vector<double> u = compenetrations(answer, step.target, work);
  const double tol = solver_tol(work) * (residual_scale(step, work, depth) / depth);
  double unused = 0;
  answer.status = SolverRun(work, answer, monitor, &answer.history)(step.control, u, 0, tol, step.target, answer.p, unused);
  return answer;
}

}  // namespace rc
