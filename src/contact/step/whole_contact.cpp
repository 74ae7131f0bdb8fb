// Under a prescribed load the trial set is one that surely holds the contact set, and solvers that only know approach control are
// called by an iteration on the approach.
#include "contact/step/whole_contact.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/step/services.h"
#include "contact/step/trial.h"
#include "contact/surface/bearing.h"
#include "contact/surface/points_below.h"
#include "core/error.h"
#include "core/limits.h"
#include "core/start_terms.h"

namespace rc {

namespace {

constexpr int most_widenings = 8;    // of enlarging the trial set
constexpr int most_approaches = 80;  // of the iteration on the approach
constexpr double growth = 1.2;
constexpr double warm_margin = 1.02;  // factor of the last step's compression, times the ratio of the loads
constexpr double near_load = 1.1;     // up to this ratio of the loads that estimate is used without another
constexpr double spare = 1.02;        // points of the trial set times the hardness, over the load, at least
constexpr double farthest_load = 4;   // ratio of two loads above which the one's pressures are no help for the other
constexpr double half_way = 0.5;      // of the missing load: with a cap a step that leaves more is followed by bisection

// The compression that the trial set must allow. A cold step takes that of a bed of springs, a warm one also the last compression
// times the ratio of loads: the load is convex in the approach, as long as no plastic indentation raises the lowest gap. It may
// be too small; then the caller widens the trial set.
double approach_estimate(double load, bool warm, const GridProblem& problem, const CertifiedStep& last) {
  const rc_system& s = problem.system.given;
  const double ratio = warm ? std::max(1.0, load / last.load) : infinite;
  const double foretold = warm ? warm_margin * (last.approach - problem.surface.lowest()) * ratio : infinite;
  if (ratio <= near_load) return foretold;
  return std::min(foretold, bed_margin * bearing_height(load / (s.modulus * std::sqrt(s.hx) * std::sqrt(s.hy)), problem.surface));
}

// Points that may carry pressure if only points with gap < limit can be in contact; all, if H has negative entries. By rows:
// every point of this process.
TrialSet trial_below(double limit, const GridProblem& problem) {
  if (problem.rows().shared()) return {problem.own_points(), {}};
  return problem.system.positive ? points_below(limit, problem.surface) : included_points(problem.surface);
}

// Newton's method on the load, which is a continuous, increasing, piecewise linear function of the approach; its slope is that of
// the points at hand whose pressure is free. A step is replaced by bisection if it leaves the bracket. With a cap the load is not
// convex: then it is bisected also after a step that left more than half of the missing load. All in dimensionless units; the
// operator's zero mode adds `shift` to the approach, which is taken out of the answer.
rc_status balance_load(Answer& answer, double load, double shift, double first, const GridProblem& problem,
                       const Attempt& attempt) {
  const TrialSet& trial = answer.op->trial();
  const std::size_t n = answer.p.size();
  const double tol = problem.options.real(RC_OPT_TOL), lowest = problem.surface.lowest();
  SolverRun run_solver(problem, answer, attempt);
  std::vector<double> height(n), u(n), ones, rate;
  std::vector<std::int64_t> contact;
  for (std::size_t i = 0; i < n; ++i)
    height[i] = problem.surface.height(static_cast<std::size_t>(trial.point(static_cast<std::int64_t>(i)))) / answer.units.length;

  const double cap = answer.units.cap();
  double low = 0, high = infinite, d = first + shift, missing = infinite;
  for (int k = 0; k < most_approaches; ++k) {
    for (std::size_t i = 0; i < n; ++i) u[i] = d - height[i];
    double unused = 0;
    answer.compression = d - shift;
    const double depth = std::max(answer.compression, 1e-3 * d), physical = lowest + answer.compression * answer.units.length;
    const rc_status solved = run_solver(RC_CONTROL_APPROACH, u, 0, 0.5 * tol * depth, physical, answer.p, unused);
    // Pressures of less than the accuracy asked for still tell where the load is.
    if (solved != RC_OK && solved != RC_STOP_STALLED && solved != RC_UNCERTIFIED) return solved;
    double sum = 0;
    contact.clear();
    for (std::size_t i = 0; i < n; ++i) {
      sum += answer.p[i];
      if (answer.p[i] > 0 && answer.p[i] < cap) contact.push_back(static_cast<std::int64_t>(i));
    }
    // A solver that can do no better is not asked for more than the tolerance.
    if (std::abs(sum - load) <= (solved == RC_OK ? 0.05 : 1) * tol * load) return solved;
    (sum < load ? low : high) = d;

    ones.assign(contact.size(), 1.0);
    rate.assign(contact.size(), 0.0);
    const rc_status status = contact.empty() ? RC_OK : answer.op->subset(contact, ones.data(), rate.data());
    if (status != RC_OK) {
      answer.op->check(status, "the slope of the load");
      return status;
    }
    double slope = 0;
    for (const double value : rate) slope += value;
    double next = d + (load - sum) / slope;
    if (next == d) return solved;  // as near as double precision comes; the certificate decides
    const bool slow = cap < infinite && high < infinite && std::abs(load - sum) > half_way * missing;
    missing = std::abs(load - sum);
    if (slow || !(next > low && next < high)) next = high < infinite ? 0.5 * (low + high) : std::max(2 * d, 1.0);
    for (std::size_t i = 0; i < contact.size(); ++i) {
      double& p = answer.p[static_cast<std::size_t>(contact[i])];
      p = std::min(std::max(0.0, p + (next - d) * rate[i]), cap);
    }
    d = next;
  }
  return RC_STOP_STALLED;
}

Answer at_approach(const GridProblem& problem, const Target& target, const Start& start, const Attempt& attempt,
                   const Pressures* nearer) {
  Trial trial(problem, target, trial_below(target.value, problem), target.compression(problem.surface), attempt);
  trial.bind();
  trial.start(start, nearer);
  trial.answer.limit = trial.answer.units.length;
  trial.solve();
  return std::move(trial.answer);
}

Answer at_load(const GridProblem& problem, const Target& target, const Start& start, const Attempt& attempt,
               std::optional<Estimate> estimate) {
  const System& system = problem.system;
  const StepSurface& surface = problem.surface;
  const Rows& rows = problem.rows();
  const CertifiedStep& last = start.last();
  const double lowest = surface.lowest(), load = target.value / system.cell_area();
  const double ratio = last.load > 0 ? target.value / last.load : infinite;
  const bool near = ratio <= farthest_load && ratio >= 1 / farthest_load, warm = near && last.same_gap;
  const bool narrow = estimate && !estimate->dense;
  double height = narrow               ? growth * (estimate->approach - lowest)
                  : system.halfspace() ? approach_estimate(target.value, warm && !start.indented(), problem, last)
                                       : surface.range().highest - lowest;
  if (!(height > 0)) height = load * system.length_per_pressure;
  const Start from = near ? start : start.cold();
  const bool foretold = warm || estimate;
  const double likely = estimate ? estimate->approach : last.approach + start.ahead() * (last.approach - start.before().approach);
  std::optional<Pressures> nearer;
  if (estimate) nearer = std::move(estimate->pressures);
  bool handed_over = false;
  for (int round = 0;; ++round) {
    double limit = std::max(lowest + height, std::nextafter(lowest, infinite));
    TrialSet set = system.halfspace() ? trial_below(limit, problem) : included_points(surface);
    while (!rows.shared() && static_cast<double>(set.n) * system.hardness < spare * load && set.n < surface.range().included) {
      height *= 2;
      limit = lowest + height;
      set = trial_below(limit, problem);
    }
    Trial trial(problem, target, std::move(set), height, attempt);
    Answer& answer = trial.answer;
    const bool direct = !handed_over && (answer.choice.solver->controls & RC_CONTROL_LOAD) != 0;
    answer.handed_over = handed_over;
    answer.limit = limit - lowest;
    // If the solver has no load control, the datum is shifted by a multiple of the load, which is prescribed: the approach then
    // determines the load even in full contact.
    const double zero_mode = system.periodic() && !direct ? system.bounds.lambda_most : 0;
    trial.bind(zero_mode);
    trial.start(from, nearer ? &*nearer : nullptr);
    nearer.reset();
    if (direct) {
      trial.solve(foretold ? std::clamp((likely - lowest) / height, 0.0, 1.0) : 0);
    } else {
      double first = foretold && likely > lowest ? (likely - lowest) / height : 1;
      if (system.periodic() && !foretold) first = (lowest + surface.moments().mean - lowest) / height;
      const double wanted = trial.load(), per_load = zero_mode / static_cast<double>(system.points());
      const double shift = zero_mode * wanted / static_cast<double>(system.points());
      answer.status = balance_load(answer, wanted, shift, first, problem, attempt);
      // The zero mode is taken out with the load that the pressures have, which is not quite the one wanted.
      const double sum = zero_mode != 0 ? std::accumulate(answer.p.begin(), answer.p.end(), 0.0) : 0;
      answer.datum_shift = per_load * sum * height;
      answer.compression = (answer.compression + per_load * (wanted - sum)) * height;
    }
    if (direct && !rows.shared() && answer.status == RC_STOP_STALLED &&
        (problem.options.integer(RC_OPT_ALLOW_FALLBACK) != 0 || answer.op->has_subset())) {
      // A solver whose own load control goes in circles may still do approach control.
      handed_over = true;
      continue;
    }
    const bool covered = rows.shared() || trial.set().n == surface.range().included || answer.compression <= answer.limit;
    const bool finite = std::isfinite(answer.compression);  // else the certificate reports it
    if (covered || !finite || answer.status != RC_OK || round == most_widenings) return std::move(answer);
    height = growth * answer.compression;
    nearer = answer.pressures();
  }
}

}  // namespace

Answer whole_contact(const GridProblem& problem, const Target& target, const Start& start, const Attempt& attempt,
                     std::optional<Estimate> estimate) {
  if (target.by_load()) return at_load(problem, target, start, attempt, std::move(estimate));
  return at_approach(problem, target, start, attempt, estimate ? &estimate->pressures : nullptr);
}

}  // namespace rc
