#include "contact/slopes/stiffness.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "contact/slopes/subset_solve.h"
#include "core/error.h"
#include "core/rows.h"

namespace rc {

namespace {

constexpr double least_tol = 1e-10, most_tol = 1e-4;  // of the solves, which follow the tolerance
constexpr double finest_residual = 1e-11;             // of those that a stiffness needs to be known to the tolerance
constexpr double unbounded = std::numeric_limits<double>::infinity();

// The pressures x of a flat punch of the shape of a set of points, and its stiffness 1'x; dimensionless.
struct FlatPunch {
  rc_status status = RC_OK;
  std::vector<double> rate;  // x, under the mean that the solve adds to H
  ContactSetBound bound;
  double mean = 0;

  // Without the rank-one mean (Sherman & Morrison 1950): grows with the sum of x.
  double stiffness(double sum) const { return sum / (1 - mean * sum); }
  // A solve that stalls at its start has x = 0.
  bool found() const { return status == RC_OK || (status == RC_STOP_STALLED && bound.form > 0); }
  double lower() const { return std::max(0.0, stiffness(std::max(0.0, bound.form - bound.error))); }
  double upper() const {
    const double most = bound.form + bound.error;
    return mean * most < 1 ? stiffness(most) : unbounded;
  }
};

// In all processes.
std::int64_t count(const GridProblem& problem, std::span<const std::int64_t> points) {
  return problem.surface.points().rows().united(static_cast<std::int64_t>(points.size()));
}

// The stiffness, and with `proven` the bound of its error, to the tolerance: x has half the digits.
FlatPunch pressed(const GridProblem& problem, Operator& op, std::span<const std::int64_t> set, std::vector<double> start,
                  bool proven) {
  SubsetSolve solve(problem, op, set);
  FlatPunch punch{RC_OK, std::move(start), {}, solve.mean()};
  std::vector<double> ones;
  problem.rows().on_all([&] {
    ones.assign(set.size(), 1.0);
    punch.rate.resize(set.size());
  });
  const double tol = std::max(problem.options.real(RC_OPT_TOL), least_tol);
  double residual = std::min(tol, most_tol);
  punch.status = solve.form(ones, residual, punch.rate, punch.bound);
  // Where few points of a period are left out, 1 - mean 1'x is close to 0, and 1'x is needed to more digits than the stiffness.
  while (punch.status == RC_OK && solve.iterates() && !punch.bound.settles(tol, punch.mean) && residual > finest_residual) {
    residual = std::max(0.1 * residual, finest_residual);
    punch.status = solve(ones, residual, punch.rate, punch.bound);
  }
  if (proven && punch.status == RC_OK) punch.status = solve.prove(ones, punch.rate, punch.bound);
  if (solve.iterates())
    problem.options.context->log(
        RC_LOG_INFO, join("stiffness: residual ", punch.bound.residual / std::sqrt(static_cast<double>(count(problem, set)))));
  return punch;
}

double in_units(const System& system, double stiffness) { return stiffness * system.cell_area() / system.length_per_pressure; }

// The punch on a set of points of the grid; those it starts from are a part of `from`, or hold it.
FlatPunch pressed_at(const GridProblem& problem, Operator& op, const std::vector<std::int64_t>& points, const Stiffness& from) {
  if (from.op == &op && !std::isnan(from.bound.error) && problem.rows().united(std::int64_t{points != from.points}) == 0)
    return {RC_OK, {}, from.bound, from.mean};
  TrialSet trial;
  std::vector<double> start;
  std::optional<std::vector<std::int64_t>> positions;
  problem.rows().on_all([&] {
    trial.n = static_cast<std::int64_t>(points.size());
    trial.index = points;
    Pressures known;
    known.on.index = from.points;
    known.p = from.rate;
    start = known.at(trial);
    positions = positions_in(op.trial(), points);
  });
  if (!positions) {  // not by rows, where operators have all points
    if (trial.n == problem.system.points()) trial.index.clear();
    op.bind(trial);
    positions = positions_in(trial, points);
  }
  return pressed(problem, op, *positions, std::move(start), true);
}

}  // namespace

Stiffness stiffness(const GridProblem& problem, const Answer& answer) {
  const System& system = problem.system;
  Stiffness result;
  result.value = 0;
  if (!answer.op) return result;
  const bool interval = problem.options.integer(RC_OPT_STIFFNESS) > 1;
  std::vector<std::int64_t> contact;
  std::vector<double> grown;
  problem.rows().on_all([&] {
    for (std::size_t i = 0; i < answer.p.size(); ++i)
      if (answer.p[i] > 0 && answer.p[i] < answer.units.cap()) contact.push_back(static_cast<std::int64_t>(i));
    // Between points in contact at both approaches the pressures have grown as a flat punch's do.
    for (const std::int64_t position : contact) {
      const auto i = static_cast<std::size_t>(position);
      if (!answer.before.empty()) grown.push_back(answer.p[i] * answer.units.pressure - answer.before[i]);
    }
  });
  const std::int64_t contacts = count(problem, contact);
  if (contacts == 0) return result;
  if (system.periodic() && contacts == system.points()) {
    result.value = unbounded;
    return result;
  }
  FlatPunch punch = pressed(problem, *answer.op, contact, std::move(grown), false);
  result.value = punch.found() ? in_units(system, punch.stiffness(punch.bound.form)) : std::numeric_limits<double>::quiet_NaN();
  if (!punch.found() || !interval) return result;
  for (std::int64_t& position : contact) position = answer.op->trial().point(position);
  result.points = std::move(contact);
  result.rate = std::move(punch.rate);
  result.op = answer.op;
  result.bound = punch.bound;
  result.mean = punch.mean;
  return result;
}

void prove_interval(const GridProblem& problem, Operator* op, const std::vector<std::int64_t>& contacts,
                    const std::vector<std::int64_t>& possible, Stiffness& stiffness) {
  const System& system = problem.system;
  const std::int64_t least_points = count(problem, contacts), most_points = count(problem, possible);
  double lower = 0, upper = most_points == 0 ? 0 : unbounded;
  if (op && most_points > 0 && !(system.periodic() && most_points == system.points())) {
    const FlatPunch most = pressed_at(problem, *op, possible, stiffness);
    if (!most.found() || std::isnan(most.bound.error)) return;
    upper = most.upper();
    if (least_points == most_points) lower = most.lower();
  }
  if (op && least_points > 0 && least_points != most_points) {
    const FlatPunch least = pressed_at(problem, *op, contacts, stiffness);
    if (!least.found() || std::isnan(least.bound.error)) return;
    lower = least.lower();
  }
  stiffness.lower = in_units(system, lower);
  stiffness.upper = in_units(system, upper);
  // The interval may be narrower than the value's own error.
  stiffness.value = std::min(std::max(stiffness.value, stiffness.lower), stiffness.upper);
}

rc_status stiffness_of_points(const GridProblem& problem, Operator& op, const std::vector<std::int64_t>& points,
                              StiffnessInterval& stiffness) {
  const System& system = problem.system;
  const FlatPunch punch = pressed_at(problem, op, points, {});
  if (!punch.found()) return punch.status;
  stiffness.value = in_units(system, punch.stiffness(punch.bound.form));
  if (std::isnan(punch.bound.error)) return punch.status;
  stiffness.lower = in_units(system, punch.lower());
  stiffness.upper = in_units(system, punch.upper());
  return punch.status;
}

}  // namespace rc
