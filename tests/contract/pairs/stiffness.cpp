// The stiffness against differences of answers, by every pair.
#include "invariance_tests.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

Problem stiffness_problem(std::int32_t boundary) {
  Problem problem = rough_problem(20, 16, boundary, 0.5, 0.75);
  problem.target *= 1.4;
  return problem;
}

// Between changes of the contact set the load is linear in the approach: the difference quotient is exact up to round-off.
void stiffness_is_the_slope(std::int32_t boundary, const Pair& pair) {
  const Problem problem = stiffness_problem(boundary);
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

}  // namespace

std::vector<Test> stiffness_tests() {
  std::vector<Test> tests;
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    add_for_pairs(tests, "stiffness_is_the_slope_of_the_load", boundary,
                  [=](const Pair& pair) { stiffness_is_the_slope(boundary, pair); });
  }
  return tests;
}

}  // namespace pairs
