// Over many surfaces of many kinds, hardly any answer of a coarser grid is farther from the answer on the whole grid than its
// goal. Answers of the whole grid are within any goal, and are not counted.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "kinds.h"
#include "statistics_tests.h"

namespace accuracy {

namespace {

constexpr std::array goals = {0.1, 0.03, 0.01};

struct Count {
  int asked = 0, coarser = 0, beyond = 0;
  double worst = 0;  // error over goal

  void add(const Count& other) {
    asked += other.asked;
    coarser += other.coarser;
    beyond += other.beyond;
    worst = std::max(worst, other.worst);
  }
};

struct Counts {
  Count by_approach, by_load;
};

// Relative error of the load or the area; in load control that of the load which belongs to the approach.
double error_of(const Problem& problem, const Answer& found, const Answer& exact, bool of_area) {
  if (of_area) return std::abs(found.result.contact_area / exact.result.contact_area - 1);
  if (problem.control == RC_CONTROL_APPROACH) return std::abs(found.result.load / exact.result.load - 1);
  Problem same = problem;
  same.control = RC_CONTROL_APPROACH;
  same.target = found.result.approach;
  return std::abs(solved(same, automatic, {{RC_OPT_TOL, "1e-8"}}).result.load / exact.result.load - 1);
}

void count(const Problem& problem, const Answer& exact, bool of_area, Count& count) {
  for (const double goal_of_error : goals) {
    const Answer found = solve(problem, automatic, goal(goal_of_error, of_area ? "area" : "load"));
    check(found.status == RC_OK || found.status == RC_WITHIN_GOAL, found.message);
    ++count.asked;
    if (found.status != RC_WITHIN_GOAL) continue;
    ++count.coarser;
    const double share = error_of(problem, found, exact, of_area) / goal_of_error;
    count.beyond += !(share <= 1);
    count.worst = std::max(count.worst, share);
  }
}

void report(const char* name, const Count& count) {
  std::printf("%-32s %5d asked %5d coarser %4d beyond, worst error %.2f of the goal\n", name, count.asked, count.coarser,
              count.beyond, count.worst);
}

Counts count_all(bool of_area, unsigned seeds) {
  Counts all;
  for (const Kind& kind : kinds()) {
    Counts own;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
      const Problem problem = kind.make(seed);
      const Answer exact = solved(problem, automatic, {{RC_OPT_TOL, "1e-8"}});
      count(problem, exact, of_area, own.by_approach);
      count(at_load(problem, exact.result.load), exact, of_area, own.by_load);
    }
    accuracy::report((kind.name + ", approach").c_str(), own.by_approach);
    accuracy::report((kind.name + ", load").c_str(), own.by_load);
    all.by_approach.add(own.by_approach);
    all.by_load.add(own.by_load);
  }
  accuracy::report("all, approach", all.by_approach);
  accuracy::report("all, load", all.by_load);
  return all;
}

void check_counts(const Counts& all, double allowed, double least_coarser) {
  for (const Count& each : {all.by_approach, all.by_load}) {
    check(each.beyond <= allowed * each.coarser, "hardly any coarser answer is beyond its goal");
    check(each.coarser >= least_coarser * each.asked, "coarser grids serve");
  }
}

void goals_of_the_load_are_met() {
  const Counts all = count_all(false, quick() ? 1 : 24);
  if (!quick()) check(all.by_approach.coarser >= 1000 && all.by_load.coarser >= 1000, "2000 coarser answers");
  check_counts(all, 0.005, 0.2);
}

void goals_of_the_area_are_met() { check_counts(count_all(true, quick() ? 1 : 4), 0.05, 0.02); }

}  // namespace

std::vector<Test> statistics_tests() {
  return {{"goals_of_the_load_are_met", goals_of_the_load_are_met}, {"goals_of_the_area_are_met", goals_of_the_area_are_met}};
}

}  // namespace accuracy
