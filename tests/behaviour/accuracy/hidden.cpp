// Detail that no coarser grid shows: the library looks at the given grid before it calls a coarser answer within its goal.
#include <algorithm>
#include <cmath>

#include "hidden_tests.h"
#include "scenes/random.h"
#include "support/surfaces.h"

namespace accuracy {

namespace {

// A sphere, and single points around its contact that touch as well: the means of blocks hide them.
Problem outer_pins() {
  Problem problem;
  constexpr std::int64_t n = 256;
  problem.system.nx = problem.system.ny = n;
  problem.target = 0.97;
  problem.gap = paraboloid(n, n, 1, n / 2, n / 2, n * n / 16.0);
  ::scenes::Random random(1, 1);
  for (int pin = 0; pin < 300; ++pin) {
    double& gap = problem.gap[static_cast<std::size_t>(random.below(n * n))];
    if (gap > 0.6) gap = random.uniform(0, 0.47);
  }
  return problem;
}

Answer exact(const Problem& problem) { return solved(problem, automatic, {{RC_OPT_TOL, "1e-8"}}); }

bool by_estimate(const Answer& found) {
  check(found.status == RC_OK || found.status == RC_WITHIN_GOAL, found.message);
  return found.status == RC_WITHIN_GOAL;
}

void pins_outside_the_coarse_contact_are_seen() {
  const Problem problem = outer_pins();
  const double load = exact(problem).result.load;
  for (const double goal_of_load : {0.1, 0.03, 0.01}) {
    const Answer found = solve(problem, automatic, goal(goal_of_load, "load"));
    check_near(found.result.load, load, goal_of_load * load, "load");
    const Answer by_load = solve(at_load(problem, load), automatic, goal(goal_of_load, "load"));
    Problem same = problem;
    same.target = by_load.result.approach;
    check_near(exact(same).result.load, load, goal_of_load * load, "load of the approach found");
  }
}

// All of every grid touches, and all counts tie.
void areas_that_tie_are_known_to_one_coarse_cell() {
  Problem problem;
  problem.system.nx = problem.system.ny = 128;
  problem.gap.assign(problem.points(), 0.0);
  problem.target = 1;
  const Answer found = solve(problem, automatic, goal(0.1, "area"));
  check(by_estimate(found), "a coarser grid will do");
  const std::int64_t factor = 128 / found.result.model_nx;
  check(found.result.error_estimate >= static_cast<double>(factor * factor) / static_cast<double>(found.result.contacts),
        "the estimate is no less than a cell");
}

// A goal of the load leaves the area to its own estimate.
void areas_under_a_goal_of_the_load_have_their_own_estimate() {
  int coarser = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const Problem by_approach = waves_problem(192, seed % 2 == 0 ? RC_BOUNDARY_PERIODIC : RC_BOUNDARY_FREE, seed, 0.3);
    const Answer whole = exact(by_approach);
    for (const Problem& problem : {by_approach, at_load(by_approach, whole.result.load)}) {
      const Answer found = solve(problem, automatic, goal(0.1, "load"));
      if (!by_estimate(found)) continue;
      ++coarser;
      const double area = whole.result.contact_area;
      check_near(found.result.contact_area, area, found.result.area_estimate * area, "contact area");
      check(found.result.area_estimate < 1, "area_estimate");
    }
  }
  check(coarser >= 3, "coarser grids serve");
}

}  // namespace

std::vector<Test> hidden_tests() {
  return RC_TESTS(pins_outside_the_coarse_contact_are_seen, areas_that_tie_are_known_to_one_coarse_cell,
                  areas_under_a_goal_of_the_load_have_their_own_estimate);
}

}  // namespace accuracy
