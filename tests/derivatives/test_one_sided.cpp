// Where a point has no pressure and no gap at once, the derivative differs from side to side, and the answer says that the point
// is undecided.
#include <cmath>

#include "calls.h"
#include "naive.h"

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

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  return run_group(
      "derivatives.one_sided",
      {{"derivatives_are_one_sided_there", derivatives_are_one_sided_there}, {"beside_it_they_are_not", beside_it_they_are_not}},
      argc, argv);
}
