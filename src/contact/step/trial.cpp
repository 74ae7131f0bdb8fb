#include "contact/step/trial.h"

#include <utility>

#include "contact/operators.h"
#include "contact/step/services.h"
#include "contact/surface/points_below.h"
#include "contact/surface/trial_box.h"

namespace rc {

namespace {

// The whole bounding box, if the solver wants it, products on it cost the same and it is at most twice as large.
TrialSet widened(TrialSet trial, const Choice& choice, const GridProblem& problem) {
  constexpr std::uint64_t by_points = RC_CAP_SUBSET | RC_CAP_SCREEN;  // backends whose products cost more with every point
  if (problem.rows().shared() || !(choice.solver->needs & RC_WANTS_BOX) || (choice.backend->caps & by_points) ||
      !problem.surface.range().whole)
    return trial;
  const rc_system& system = problem.system.given;
  const std::int64_t box = box_points(trial, system.nx, system.ny);
  return trial.n < box && 2 * trial.n >= box ? box_of(trial, system.nx, system.ny) : trial;
}

// The dimensionless u = (datum - gap) / unit; empty if the solver reads the gap itself.
std::vector<double> penetrations(const Answer& answer, double datum, const GridProblem& problem) {
  GatheredTiles* const gathered = problem.surface.gathered();
  if (!gathered && problem.system.halfspace() && takes_gap(*answer.choice.solver, problem.options)) return {};
  const TrialSet& trial = answer.op->trial();
  if (gathered) gathered->hold_tiles_of(trial.index);
  std::vector<double> u(static_cast<std::size_t>(trial.n));
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] = (datum - problem.surface.gap_at(static_cast<std::size_t>(trial.point(static_cast<std::int64_t>(i))))) /
           answer.units.length;
  return u;
}

}  // namespace

TrialSet trial_below(double limit, const GridProblem& problem) {
  if (problem.rows().shared()) return {problem.own_points(), {}};
  return problem.system.positive ? points_below(limit, problem.surface) : included_points(problem.surface);
}

Trial::Trial(const GridProblem& problem, const Step& step, TrialSet set, double unit, const Attempt& attempt,
             std::optional<Choice> choice)
    : problem_(problem), step_(step), set_(std::move(set)), attempt_(attempt) {
  const Choice by = choice ? *choice : choose_for(problem, set_, step.target.control, attempt.failed, step.look > 0);
  answer = answer_in(unit, by, problem.system);
  if (!choice) set_ = widened(std::move(set_), answer.choice, problem);
}

void Trial::bind(double zero_mode) {
  set_.zero_mode = zero_mode;
  answer.op = &problem_.operators().bound(*answer.choice.backend, set_);
}

void Trial::start(const Memory& memory, const Step& from, const Pressures* nearer) {
  problem_.rows().on_all(
      [&] { answer.p = memory.start(from, set_, answer.units.pressure, answer.units.cap(), nearer, problem_.team()); });
}

void Trial::continue_from(const Memory& memory, const Step& from, bool of_earlier) {
  follows_ = true;
  if (of_earlier) answer.history = memory.history(from);
  if (problem_.options.integer(RC_OPT_STIFFNESS) != 0) answer.before = memory.earlier(from, set_);
}

void Trial::solve(double load, double tol, double datum, double& d) {
  const std::vector<double> u = penetrations(answer, datum, problem_);
  SolverRun run(problem_, answer, attempt_, step_.look, follows_ ? &answer.history : nullptr);
  answer.status = run(step_.target.control, u, load, tol, datum, answer.p, d);
}

}  // namespace rc
