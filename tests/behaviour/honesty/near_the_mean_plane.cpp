// Periodic boundaries, an approach just below the mean plane: gaps are small under any load, so small gaps alone must not make a
// certificate.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "honesty_tests.h"
#include "support/contact.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

// The approach is below the mean plane by `share` of the range of heights.
Problem below_the_mean(Problem problem, double share) {
  const Field& gap = problem.gap;
  const double mean = std::accumulate(gap.begin(), gap.end(), 0.0) / static_cast<double>(gap.size());
  const double range = *std::max_element(gap.begin(), gap.end()) - *std::min_element(gap.begin(), gap.end());
  problem.control = RC_CONTROL_APPROACH;
  problem.target = mean - share * range;
  return problem;
}

Problem two_points() {
  Problem problem;
  problem.system.ny = 2;
  problem.system.boundary = RC_BOUNDARY_PERIODIC;
  problem.gap = {0, 1};
  return problem;
}

constexpr std::int64_t loose_side = 16;  // a thousand points would take fifty times as long

Problem waves(std::int64_t side = 32) { return rough_problem(side, side, RC_BOUNDARY_PERIODIC); }

// A certified answer has the load of the exact solution; any other has a status that says so.
void check_load(const Problem& problem, double exact, const Pair& pair, double tol, const Field* start) {
  const Contact contact(problem, pair, {{RC_OPT_TOL, text(tol)}, {RC_OPT_MAX_ITER, "20000"}});
  rc_step step = problem.step();
  if (start) step.p0.data = start->data();
  const Answer answer = contact.solve(step);
  const std::string what = pair.name() + " at " + text(tol) + ": load " + text(answer.result.load) + " instead of " + text(exact);
  check(answer.status >= 0, answer.message);
  if (answer.status == RC_OK) check(std::abs(answer.result.load - exact) <= 0.05 * exact, what);
  check(answer.result.load_lower <= exact * (1 + 1e-9) && exact <= answer.result.load_upper * (1 + 1e-9), "interval: " + what);
}

void for_all_solvers(const Problem& problem, double tol) {
  const Field far(problem.points(), 1e3 * problem.system.modulus);
  const double exact = solved(problem, {"nnls", "dense"}, {{RC_OPT_TOL, "1e-11"}, {RC_OPT_BOUNDS, "0"}}).result.load;
  for (const std::string& solver : solver_names()) {
    const Pair pair{solver, "dense"};
    if (!obstacle(pair, problem.system, problem.control).empty()) continue;
    check_load(problem, exact, pair, tol, nullptr);
    check_load(problem, exact, pair, tol, &far);
  }
}

void waves_at_loose_tolerances() {
  for (const auto& [share, tol] : {std::pair{1e-5, 1e-4}, {1e-7, 1e-6}, {1e-4, 1e-2}})
    for_all_solvers(below_the_mean(waves(loose_side), share), tol);
}

void two_points_at_loose_tolerances() {
  for (const auto& [share, tol] : {std::pair{1e-5, 1e-4}, {1e-7, 1e-6}, {1e-4, 1e-2}})
    for_all_solvers(below_the_mean(two_points(), share), tol);
}

// A uniform pressure added everywhere leaves the gaps as they are.
void more_pressure_is_not_certified() {
  const Problem problem = below_the_mean(waves(), 1e-6);
  const Contact contact(problem, {"nnls", "dense"}, {{RC_OPT_TOL, "1e-4"}});
  const Answer answer = contact.solve(problem);
  check_status(answer, RC_OK);
  for (const double factor : {1.0, 10.0, 1e4}) {
    Field more = answer.p;
    for (double& p : more) p += factor * answer.result.mean_pressure;
    check_status(contact.certify(problem.step(), more), RC_UNCERTIFIED, text(1 + factor) + " times the load");
  }
}

void unbounded_intervals_are_told() {
  const std::string words = "no upper bound of the load";
  const Answer full = solved(at_load(waves(), 1e6), {"nnls", "dense"});
  check(std::isinf(full.result.load_upper), "the interval is bounded");
  check(std::string(full.result.note).find(words) != std::string::npos, full.result.note);
  const Answer below = solved(waves(), {"nnls", "dense"});
  check(std::isfinite(below.result.load_upper), "the interval is unbounded");
  check(std::string(below.result.note).find(words) == std::string::npos, below.result.note);
}

// Load control: the scale is the load's, and full contact of a flat surface has one.
void full_contact_of_a_flat_surface_is_certified() {
  Problem problem = waves();
  std::fill(problem.gap.begin(), problem.gap.end(), 7.0);
  for (const char* solver : {"polonsky-keer", "gp", "haar-cg", "nnls"}) {
    const Answer answer = solved(at_load(problem, 1e3), {solver, "dense"}, {{RC_OPT_TOL, "1e-10"}});
    check_near(answer.result.contact_area, 1024 * problem.cell_area(), 1e-9, solver);
  }
}

}  // namespace

std::vector<Test> near_the_mean_plane() {
  return RC_TESTS(waves_at_loose_tolerances, two_points_at_loose_tolerances, more_pressure_is_not_certified,
                  unbounded_intervals_are_told, full_contact_of_a_flat_surface_is_certified);
}

}  // namespace pairs
