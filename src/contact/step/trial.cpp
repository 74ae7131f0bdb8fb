#include "contact/step/trial.h"

#include <utility>

#include "contact/operators.h"
#include "contact/proof/certificate.h"
#include "contact/step/services.h"
#include "contact/trial_box.h"

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
  if (!problem.surface.gathered() && problem.system.halfspace() && takes_gap(*answer.choice.solver, problem.options)) return {};
  const TrialSet& trial = answer.op->trial();
  problem.surface.hold_tiles_of(trial.index);
  std::vector<double> u(static_cast<std::size_t>(trial.n));
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] = (datum - problem.surface.gap_at(static_cast<std::size_t>(trial.point(static_cast<std::int64_t>(i))))) /
           answer.units.length;
  return u;
}

}  // namespace

Trial::Trial(const GridProblem& problem, const Target& target, TrialSet set, double unit, const Attempt& attempt,
             std::optional<Choice> choice)
    : problem_(problem), target_(target), set_(std::move(set)), attempt_(attempt) {
  const Choice by = choice ? *choice : choose_for(problem, set_, target.control, attempt.failed, attempt.look > 0);
  answer = answer_in(unit, by, problem.system);
  if (!choice) set_ = widened(std::move(set_), answer.choice, problem);
}

void Trial::bind(double zero_mode) {
  set_.zero_mode = zero_mode;
  answer.op = &problem_.operators().bound(*answer.choice.backend, set_);
}

void Trial::start(const Pressures& estimate) { answer.p = dimensionless(estimate, set_, answer.units); }

void Trial::start(const Start& from, const Pressures* nearer) {
  problem_.rows().on_all([&] {
    answer.p = nearer ? dimensionless(*nearer, set_, answer.units) : from.pressures(set_, answer.units, problem_.team());
  });
  follows_ = true;
  if (!nearer) answer.history = from.kept();
  if (problem_.options.integer(RC_OPT_STIFFNESS) != 0) answer.before = from.earlier(set_);
}

double Trial::load() const { return target_.by_load() ? target_.value / problem_.system.cell_area() / answer.units.pressure : 0; }

double Trial::scale(double compression) const { return residual_scale(problem_, target_, compression); }

// The tolerance is a little less than that of the step, because the certificate's product rounds differently.
void Trial::solve(double first) {
  const bool by_load = target_.by_load();
  const double unit = answer.units.length, datum = by_load ? problem_.surface.lowest() : target_.value;
  const double tol = 0.98 * problem_.options.real(RC_OPT_TOL) * (by_load ? 1 : scale(unit) / unit);
  const std::vector<double> u = penetrations(answer, datum, problem_);
  SolverRun run(problem_, answer, attempt_, follows_ ? &answer.history : nullptr);
  double d = by_load ? first : 0;
  answer.status = run(target_.control, u, load(), tol, datum, answer.p, d);
  answer.compression = by_load ? d * unit : target_.compression(problem_.surface);
}

}  // namespace rc
