// Detail that no coarser grid shows: the library looks at the given grid before it calls a coarser answer within its goal.
#include <algorithm>
#include <cmath>

#include "hidden_tests.h"

namespace accuracy {

namespace {

struct Pin {
  int column, row;
  double depth;
};
constexpr Pin pins[] = {
#include "outer_pins.inc"
};

// A sphere, and single points around its contact that touch as well: the means of blocks hide them.
Problem outer_pins() {
  Problem problem;
  constexpr std::int64_t n = 256;
  problem.system.nx = problem.system.ny = n;
  problem.target = 0.9701643099750756;
  for (std::int64_t iy = 0; iy < n; ++iy)
    for (std::int64_t ix = 0; ix < n; ++ix)
      problem.gap.push_back(8.0 * static_cast<double>((ix - n / 2) * (ix - n / 2) + (iy - n / 2) * (iy - n / 2)) / (n * n));
  for (const Pin& pin : pins) problem.gap[static_cast<std::size_t>(pin.row * n + pin.column)] = pin.depth;
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
  check_near(load, 123.0, 0.1, "load of the whole grid");
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

// Contacts that lie far apart, of which block means lower one more than the other.
void two_spheres_meet_their_goals() {
  int coarser[2] = {0, 0};  // answers by approach and by load
  for (const double radius : {0.05, 0.2, 0.8})
    for (const double lower : {0.0, 0.002}) {
      Problem problem;
      constexpr std::int64_t n = 192;
      problem.system.nx = problem.system.ny = n;
      problem.system.hx = problem.system.hy = 1.0 / n;
      for (std::int64_t iy = 0; iy < n; ++iy)
        for (std::int64_t ix = 0; ix < n; ++ix) {
          const double x = (static_cast<double>(ix) + 0.5) / n - 0.5, y = (static_cast<double>(iy) + 0.5) / n - 0.5;
          problem.gap.push_back(
              std::min((std::pow(x + 0.2, 2) + y * y) / 2, (std::pow(x - 0.2, 2) + std::pow(y - 0.1, 2)) / (2 * radius) + lower));
        }
      problem.target = 0.006;
      const double load = exact(problem).result.load;
      for (const double goal_of_load : {0.03, 0.01, 0.003}) {
        const Answer found = solve(problem, automatic, goal(goal_of_load, "load"));
        coarser[0] += by_estimate(found);
        check_near(found.result.load, load, goal_of_load * load, "load");
        const Answer by_load = solve(at_load(problem, load), automatic, goal(goal_of_load, "load"));
        coarser[1] += by_estimate(by_load);
        Problem same = problem;
        same.target = by_load.result.approach;
        check_near(exact(same).result.load, load, goal_of_load * load, "load of the approach found");
      }
    }
  report(std::to_string(coarser[0]) + " of 18 answers on coarser grids by approach, " + std::to_string(coarser[1]) + " by load");
  check(coarser[0] >= 6 && coarser[1] >= 6, "coarser grids serve");
}

}  // namespace

std::vector<Test> hidden_tests() {
  return {{"pins_outside_the_coarse_contact_are_seen", pins_outside_the_coarse_contact_are_seen},
          {"areas_that_tie_are_known_to_one_coarse_cell", areas_that_tie_are_known_to_one_coarse_cell},
          {"areas_under_a_goal_of_the_load_have_their_own_estimate", areas_under_a_goal_of_the_load_have_their_own_estimate},
          {"two_spheres_meet_their_goals", two_spheres_meet_their_goals}};
}

}  // namespace accuracy
