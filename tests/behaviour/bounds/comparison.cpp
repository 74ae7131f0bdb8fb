#include "comparison.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pairs {

namespace {

constexpr double exactness = 1e-11;  // of the solutions taken for exact, relative

bool may_carry(const Problem& problem, std::size_t i, double approach) {
  const bool positive = problem.system.op == RC_OPERATOR_HALFSPACE && !problem.periodic();
  return problem.included(i) && (!positive || problem.gap[i] < approach);
}

// The result counts; which points it means follows from the order in which they are proven: open those that cannot carry pressure
// and then those with the largest gaps, in contact the others with the largest pressures.
void check_points(const Problem& problem, const Answer& answer, const Answer& exact) {
  const rc_result& r = answer.result;
  std::vector<std::size_t> order(problem.points());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto distance = [&](std::size_t i) { return may_carry(problem, i, r.approach) ? answer.gap[i] : HUGE_VAL; };
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return distance(a) > distance(b); });
  const double negligible = exactness * largest(exact.p);
  for (std::int64_t k = 0; k < r.proven_open; ++k) {
    const std::size_t i = order[static_cast<std::size_t>(k)];
    check(exact.p[i] <= negligible, "point " + std::to_string(i) + " is proven open but carries " + text(exact.p[i]));
  }
  std::sort(order.begin() + r.proven_open, order.end(), [&](std::size_t a, std::size_t b) { return answer.p[a] > answer.p[b]; });
  for (std::int64_t k = 0; k < r.proven_contacts; ++k) {
    const std::size_t i = order[static_cast<std::size_t>(r.proven_open + k)];
    check(exact.p[i] > 0, "point " + std::to_string(i) + " is proven to be in contact but carries " + text(exact.p[i]));
  }
}

void check_gaps(const Problem& problem, const Answer& answer, const Answer& exact) {
  const rc_result& r = answer.result;
  const double scale = largest(exact.gap) + std::abs(r.approach);
  for (std::size_t i = 0; std::isfinite(r.gap_error) && i < problem.points(); ++i) {
    const double error = std::abs(answer.gap[i] - exact.gap[i]);
    if (problem.included(i))
      check(error <= r.gap_error + exactness * scale,
            "the gap of point " + std::to_string(i) + " is off by " + text(error) + ", proven are " + text(r.gap_error));
  }
}

}  // namespace

Answer exact_at(const Problem& problem, double approach) {
  Problem same = problem;
  same.control = RC_CONTROL_APPROACH;
  same.target = approach;
  return solve(same, {"nnls", "dense"}, {{RC_OPT_TOL, "1e-14"}, {RC_OPT_BOUNDS, "0"}});
}

void check_proofs(const Problem& problem, const Answer& answer, const Answer& exact) {
  const rc_result &r = answer.result, &e = exact.result;
  check(e.approach == r.approach, "the exact solution is at another approach");
  if (problem.periodic() && r.points == 1) {  // no wave, no H
    check_equal(r.proven_contacts, -1, "proven_contacts");
    return;
  }
  check_equal(r.proven_contacts + r.proven_open + r.undecided, r.points, "proven and undecided points");
  check_near(r.area_lower, static_cast<double>(r.proven_contacts) * problem.cell_area(), 1e-12 * r.area_lower, "area_lower");
  check_near(r.area_upper, static_cast<double>(r.points - r.proven_open) * problem.cell_area(), 1e-12 * r.area_upper,
             "area_upper");
  check_points(problem, answer, exact);

  const double negligible = exactness * largest(exact.p), cell = problem.cell_area();
  const double most = static_cast<double>(std::ranges::count_if(exact.p, [](double p) { return p > 0; })) * cell,
               least = static_cast<double>(std::ranges::count_if(exact.p, [&](double p) { return p > negligible; })) * cell;
  check(r.area_lower <= most * (1 + 1e-12) && least <= r.area_upper * (1 + 1e-12),
        "area " + text(most) + " is not in " + text(r.area_lower) + " .. " + text(r.area_upper));
  check(r.load_lower <= e.load * (1 + exactness) && e.load * (1 - exactness) <= r.load_upper,
        "load " + text(e.load) + " is not in " + text(r.load_lower) + " .. " + text(r.load_upper));
  check_gaps(problem, answer, exact);
  if (std::isnan(r.duality_gap)) {
    check(r.load_lower == 0 && std::isinf(r.load_upper) && r.proven_contacts == 0, "bounds without a gap");
  } else {
    check(r.energy - e.energy <= r.duality_gap * (1 + 1e-9) + 1e-15 * std::abs(e.energy),
          "energy is " + text(r.energy - e.energy) + " above the least, duality gap " + text(r.duality_gap));
  }
}

Tightness tightness(const Answer& answer, const Answer& exact) {
  const rc_result& r = answer.result;
  const double error = std::max(std::abs(r.load - exact.result.load), 1e-16 * exact.result.load);
  return {0.5 * (r.load_upper - r.load_lower) / error,
          static_cast<double>(r.undecided) / static_cast<double>(std::max<std::int64_t>(r.contacts, 1))};
}

}  // namespace pairs
