// Stiffness and energy against differences of answers.
#include <cmath>

#include "invariance_tests.h"
#include "support/naive.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

Problem derivative_problem(std::int32_t boundary) {
  Problem problem = rough_problem(20, 16, boundary, 0.5, 0.75);
  problem.target *= 1.4;
  return problem;
}

// Between changes of the contact set the load is linear in the approach: the difference quotient is exact up to round-off.
void stiffness_is_the_slope(std::int32_t boundary, const Pair& pair) {
  const Problem problem = derivative_problem(boundary);
  Problem below = problem, above = problem;
  const double step = 1e-5 * problem.target;
  below.target -= step;
  above.target += step;
  const Answer low = solved(below, pair), high = solved(above, pair);
  check_equal(low.result.contacts, high.result.contacts, "the contact set must not change between the two approaches");
  const double slope = (high.result.load - low.result.load) / (2 * step);
  const Answer answer = solved(problem, pair, {{RC_OPT_STIFFNESS, "1"}});
  check_near(answer.result.stiffness, slope, 1e-6 * slope, "stiffness");
  const Answer loaded = solved(at_load(problem, answer.result.load), pair, {{RC_OPT_STIFFNESS, "1"}});
  check_near(loaded.result.stiffness, slope, 1e-6 * slope, "stiffness in load control");
}

void energy_is_the_functional(std::int32_t boundary, const Pair& pair) {
  const Problem problem = derivative_problem(boundary);
  const Answer answer = solved(problem, pair);
  const Certificate expected = certificate(problem, influence_matrix(problem), answer.p, problem.target);
  check_near(answer.result.energy, expected.energy, 1e-12 * std::abs(expected.energy), "energy");
  // At the solution p'(H p) = (d - h)'p.
  double work = 0;
  for (std::size_t i = 0; i < answer.p.size(); ++i) work += (problem.target - problem.gap[i]) * answer.p[i] * problem.cell_area();
  check_near(answer.result.energy, -0.5 * work, 1e-10 * work, "energy as minus half the work");
}

// d(energy)/dd = -W.
void energy_falls_with_the_load(std::int32_t boundary, const Pair& pair) {
  const Problem problem = derivative_problem(boundary);
  Problem below = problem, above = problem;
  const double step = 1e-4 * problem.target;
  below.target -= step;
  above.target += step;
  const double slope = (solved(above, pair).result.energy - solved(below, pair).result.energy) / (2 * step);
  check_near(slope, -solved(problem, pair).result.load, 1e-5 * std::abs(slope), "slope of the energy");
}

void load_and_contact_grow_with_approach(std::int32_t boundary, const Pair& pair) {
  Problem problem = derivative_problem(boundary);
  const double top = problem.target;
  Field loads = {0};
  Field last(problem.points(), 0.0);
  for (int k = 1; k <= 6; ++k) {
    problem.target = top * k / 6;
    const Answer answer = solved(problem, pair);
    loads.push_back(answer.result.load);
    // Grow by more each time: the load is convex in the approach.
    if (k > 1) check(loads[k] - loads[k - 1] > loads[k - 1] - loads[k - 2], "the load is not convex in the approach");
    for (std::size_t i = 0; i < last.size(); ++i)
      check(last[i] == 0 || answer.p[i] > 0, "a point in contact is lost at a larger approach");
    last = answer.p;
  }
}

}  // namespace

std::vector<Test> derivative_tests() {
  std::vector<Test> tests;
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    const auto add = [&](const char* name, void (*body)(std::int32_t, const Pair&)) {
      add_for_pairs(tests, name, boundary, [=](const Pair& pair) { body(boundary, pair); });
    };
    add("stiffness_is_the_slope_of_the_load", stiffness_is_the_slope);
    add("energy_is_the_functional_that_is_minimised", energy_is_the_functional);
    add("energy_falls_by_the_load_with_the_approach", energy_falls_with_the_load);
    add("load_is_convex_and_contact_grows_with_the_approach", load_and_contact_grow_with_approach);
  }
  return tests;
}

}  // namespace pairs
