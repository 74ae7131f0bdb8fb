// Over many surfaces, at least 95 % of the runs differ from the answer on the whole grid by no more than their goal.
#include <array>
#include <cmath>
#include <functional>

#include "statistics_tests.h"

namespace accuracy {

namespace {

constexpr std::array goals = {0.1, 0.03, 0.01};
constexpr std::array depths = {0.15, 0.5, 1.0};

struct Count {
  int runs = 0, within = 0, of_load = 0, coarser = 0;  // coarser: of those with a goal of the load
};

// Relative error of the load or the area; in load control that of the load which belongs to the approach.
double error_of(const Problem& problem, const Answer& found, const Answer& exact, bool of_area) {
  if (of_area) return std::abs(found.result.contact_area / exact.result.contact_area - 1);
  if (problem.control == RC_CONTROL_APPROACH) return std::abs(found.result.load / exact.result.load - 1);
  Problem same = problem;
  same.control = RC_CONTROL_APPROACH;
  same.target = found.result.approach;
  return std::abs(solved(same, automatic, {{RC_OPT_TOL, "1e-9"}}).result.load / exact.result.load - 1);
}

void count_runs(const Problem& by_approach, Count& count) {
  const Answer exact = solved(by_approach, automatic, {{RC_OPT_TOL, "1e-9"}});
  for (const Problem& problem : {by_approach, at_load(by_approach, exact.result.load)})
    for (const char* const of : {"load", "area"})
      for (const double error : goals) {
        const Answer found = solve(problem, automatic, goal(error, of));
        check(found.status == RC_OK || found.status == RC_WITHIN_GOAL, found.message);
        ++count.runs;
        const bool of_area = of == std::string("area");
        count.of_load += !of_area;
        count.coarser += !of_area && found.status == RC_WITHIN_GOAL;
        count.within += error_of(problem, found, exact, of_area) <= error;
      }
}

void check_count(const Count& count, double least_coarser) {
  report(std::to_string(count.within) + " of " + std::to_string(count.runs) + " runs within their goal, " +
         std::to_string(count.coarser) + " of " + std::to_string(count.of_load) + " for the load on coarser grids");
  check(count.within >= 0.95 * count.runs, "95 % of the runs are within their goal");
  check(count.coarser >= least_coarser * count.of_load, "coarser grids serve");
}

int seeds() { return quick() ? 1 : 12; }

void midpoint_displacement() {
  Count count;
  for (int seed = 1; seed <= seeds(); ++seed)
    for (const double hurst : {0.3, 0.7, 0.9})
      for (const double depth : depths) count_runs(midpoint_problem(8, hurst, static_cast<std::uint64_t>(seed), depth), count);
  check_count(count, 0.1);
}

void random_waves() {
  Count count;
  for (int seed = 1; seed <= seeds(); ++seed)
    for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
      for (const double depth : depths) count_runs(waves_problem(128, boundary, static_cast<unsigned>(seed), 0.9 * depth), count);
  check_count(count, 0.4);
}

}  // namespace

std::vector<Test> statistics_tests() {
  return {{"midpoint_displacement_meets_its_goals", midpoint_displacement}, {"random_waves_meet_their_goals", random_waves}};
}

}  // namespace accuracy
