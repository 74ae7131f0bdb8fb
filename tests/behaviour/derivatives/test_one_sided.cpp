// Where a point has no pressure and no gap at once, the derivative differs from side to side, and the answer says that the point
// is undecided.
#include <cmath>

#include "calls.h"
#include "support/naive.h"

namespace pairs {

namespace {

// Two cells of which the second only just touches.
Problem just_touching() {
  Problem problem;
  problem.system.nx = 2;
  problem.system.ny = 1;
  const Field h = influence_matrix(problem);
  problem.target = 1;
  problem.gap = {0, 1 - h[1] / h[0]};  // what the first cell's pressure leaves
  return problem;
}

double load_at(Problem problem, double approach) {
  problem.target = approach;
  return solved(problem, {"nnls", "dense"}).result.load;
}

void derivatives_are_one_sided_there() {
  const Problem problem = just_touching();
  const Contact contact(problem, {"nnls", "dense"});
  const Answer answer = contact.solve(problem);
  check_status(answer, RC_OK);
  const Gradient found = gradient(contact, 2);
  check_equal(found.status, RC_OK, found.message);
  check_equal(found.result.undecided, answer.result.undecided, "undecided");
  check(found.result.undecided >= 1, "the point that only just touches is decided");
  const double step = 1e-4, load = load_at(problem, 1), from_below = (load - load_at(problem, 1 - step)) / step,
               from_above = (load_at(problem, 1 + step) - load) / step;
  check(from_above > 1.3 * from_below, "the load has no kink there");
  const double nearest = std::min(std::abs(found.result.dJ_dtarget - from_below), std::abs(found.result.dJ_dtarget - from_above));
  check(nearest <= 1e-8 * from_above, "the derivative is that of neither side");
}

// On both sides of the kink the derivative is the slope there, and nothing is undecided.
void beside_it_they_are_not() {
  for (const double side : {-1.0, 1.0}) {
    Problem problem = just_touching();
    problem.target += 1e-3 * side;
    const Contact contact(problem, {"nnls", "dense"});
    check_status(contact.solve(problem), RC_OK);
    const Gradient found = gradient(contact, 2);
    check_equal(found.result.undecided, 0, "undecided");
    const double step = 1e-4,
                 slope = (load_at(problem, problem.target + step) - load_at(problem, problem.target - step)) / (2 * step);
    check_near(found.result.dJ_dtarget, slope, 1e-9 * slope, "dload/dd");
  }
}

// The approach is the lowest gap: the slope is 0 below it, and that of the points that touch above.
void first_touch_is_one_sided() {
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
    for (const int lowest : {1, 2}) {
      Problem problem;
      problem.system.boundary = boundary;
      problem.system.nx = 6;
      problem.system.ny = 5;
      for (int i = 0; i < 30; ++i) problem.gap.push_back(i % 11 < lowest && i < 11 ? 0.25 : 1 + 0.01 * i);
      problem.target = 0.25;
      const Contact contact(problem, {"nnls", "dense"}, {{RC_OPT_STIFFNESS, "2"}});
      const Answer answer = contact.solve(problem);
      check_status(answer, RC_OK);
      check(answer.result.load == 0, "load");
      check_equal(answer.result.undecided, lowest, "undecided");
      const Gradient found = gradient(contact, 30);
      check_equal(found.status, RC_OK, found.message);
      check_equal(found.result.undecided, lowest, "undecided of the gradient");
      const double step = 1e-4, above = load_at(problem, problem.target + step) / step;
      check(found.result.dJ_dtarget == 0, "the derivative is that from below");
      check(answer.result.stiffness_lower == 0, "the stiffness from below");
      check_near(answer.result.stiffness_upper, above, 1e-6 * above, "the stiffness from above");
    }
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  return run_group("derivatives.one_sided",
                   RC_TESTS(derivatives_are_one_sided_there, beside_it_they_are_not, first_touch_is_one_sided), argc, argv);
}
