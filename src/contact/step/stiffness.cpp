#include "contact/step/stiffness.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "contact/step/subset_solve.h"
#include "core/error.h"

namespace rc {

namespace {

constexpr double least_tol = 1e-10, most_tol = 1e-4;  // of the solves, which follow the tolerance
constexpr double unbounded = std::numeric_limits<double>::infinity();

// The pressures x of a flat punch of the shape of a set of points, and its stiffness 1'x; dimensionless.
struct FlatPunch {
  rc_status status = RC_OK;
  std::vector<double> rate;  // x, under the mean that the solve adds to H
  ContactSetBound bound;
  double mean = 0;

  // Without the rank-one mean (Sherman & Morrison 1950): grows with the sum of x.
  double stiffness(double sum) const { return sum / (1 - mean * sum); }
  double lower() const { return std::max(0.0, stiffness(std::max(0.0, bound.form - bound.error))); }
  double upper() const {
    const double most = bound.form + bound.error;
    return mean * most < 1 ? stiffness(most) : unbounded;
  }
};

enum class Wanted { form, rate, proof };  // to the tolerance: the form alone; or x, of which the form has twice the digits

FlatPunch pressed(Workspace& work, Operator& op, std::span<const std::int64_t> set, std::vector<double> start, Wanted wanted) {
  SubsetSolve solve(work, op, set);
  FlatPunch punch{RC_OK, std::move(start), {}, solve.mean()};
  const std::vector<double> ones(set.size(), 1.0);
  punch.rate.resize(set.size());
  const double tol = std::clamp(work.options.real(RC_OPT_TOL), least_tol, most_tol);
  punch.status =
      wanted == Wanted::form ? solve.form(ones, tol, punch.rate, punch.bound) : solve(ones, tol, punch.rate, punch.bound);
  if (wanted == Wanted::proof && punch.status == RC_OK) punch.status = solve.prove(ones, punch.rate, punch.bound);
  if (solve.iterates())
    work.options.context->log(RC_LOG_INFO,
                              join("stiffness: residual ", punch.bound.residual / std::sqrt(static_cast<double>(ones.size()))));
  return punch;
}

double in_units(const System& system, double stiffness) { return stiffness * system.cell_area() / system.length_per_pressure; }

bool all_of(const System& system, std::span<const std::int64_t> points) {
  return static_cast<std::int64_t>(points.size()) == system.points();
}

// The punch on a set of points of the grid; those it starts from are a part of `from`, or hold it.
FlatPunch pressed_at(Workspace& work, Operator& op, const std::vector<std::int64_t>& points, const Stiffness& from) {
  TrialSet trial;
  trial.n = static_cast<std::int64_t>(points.size());
  trial.index = points;
  Pressures known;
  known.on.index = from.points;
  known.p = from.rate;
  std::vector<double> start = known.at(trial);
  std::optional<std::vector<std::int64_t>> positions = positions_in(op.trial(), points);
  if (!positions) {
    if (all_of(work.system, points)) trial.index.clear();
    op.bind(trial);
    positions = positions_in(trial, points);
  }
  return pressed(work, op, *positions, std::move(start), Wanted::proof);
}

}  // namespace

Stiffness stiffness(Workspace& work, const Answer& answer) {
  const System& system = work.system;
  Stiffness result;
  result.value = 0;
  if (!answer.op) return result;
  std::vector<std::int64_t> contact;
  for (std::size_t i = 0; i < answer.p.size(); ++i)
    if (answer.p[i] > 0 && answer.p[i] < answer.cap()) contact.push_back(static_cast<std::int64_t>(i));
  if (contact.empty()) return result;
  if (system.periodic() && all_of(system, contact)) {
    result.value = unbounded;
    return result;
  }
  // Between points in contact at both approaches the pressures have grown as a flat punch's do.
  const bool interval = work.options.integer(RC_OPT_STIFFNESS) > 1;  // which may be narrower than the tolerance
  std::vector<double> grown;
  for (const std::int64_t position : contact) {
    const auto i = static_cast<std::size_t>(position);
    if (!interval && !answer.before.empty()) grown.push_back(answer.p[i] * answer.pressure_unit - answer.before[i]);
  }
  FlatPunch punch = pressed(work, *answer.op, contact, std::move(grown), interval ? Wanted::rate : Wanted::form);
  result.value =
      punch.status == RC_OK ? in_units(system, punch.stiffness(punch.bound.form)) : std::numeric_limits<double>::quiet_NaN();
  if (punch.status != RC_OK || !interval) return result;
  for (std::int64_t& position : contact) position = answer.op->trial().point(position);
  result.points = std::move(contact);
  result.rate = std::move(punch.rate);
  return result;
}

void prove_interval(Workspace& work, Operator* op, Stiffness& stiffness) {
  const System& system = work.system;
  if (!work.record.proven) return;
  const auto& [contacts, possible] = *work.record.proven;
  double lower = 0, upper = possible.empty() ? 0 : unbounded;
  if (op && !possible.empty() && !(system.periodic() && all_of(system, possible))) {
    const FlatPunch most = pressed_at(work, *op, possible, stiffness);
    if (most.status != RC_OK || std::isnan(most.bound.error)) return;
    upper = most.upper();
    if (contacts == possible) lower = most.lower();
  }
  if (op && !contacts.empty() && contacts != possible) {
    const FlatPunch least = pressed_at(work, *op, contacts, stiffness);
    if (least.status != RC_OK || std::isnan(least.bound.error)) return;
    lower = least.lower();
  }
  stiffness.lower = in_units(system, lower);
  stiffness.upper = in_units(system, upper);
}

}  // namespace rc
