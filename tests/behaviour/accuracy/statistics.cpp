// Over many random surfaces of the scenes, hardly any answer of a coarser grid is farther from the answer on the whole grid than
// its goal. Answers of the whole grid are within any goal, and are not counted.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "scenes.h"
#include "scenes/heights.h"
#include "statistics_tests.h"

namespace accuracy {

namespace {

constexpr std::array goals = {0.1, 0.03, 0.01};
constexpr std::int64_t side = 128;

// Heights 0 to 1, linear between every k-th point: few surfaces with details on single cells have a coarser grid that serves.
Field random_surface(::scenes::Random& random) {
  const std::int64_t k = random.chance(0.2) ? 1 : std::int64_t{1} << random.between(2, 5), knots = side / k + 1;
  const Field z = ::scenes::random_heights(knots, knots, random).z;
  const auto [low, high] = std::ranges::minmax(z);
  const auto at = [&, low = low, range = high > low ? high - low : 1](std::int64_t x, std::int64_t y) {
    return (z[static_cast<std::size_t>(y * knots + x)] - low) / range;
  };
  Field all;
  for (std::int64_t i = 0; i < side * side; ++i) {
    const std::int64_t x = i % side / k, y = i / side / k;
    const double right = static_cast<double>(i % side % k) / static_cast<double>(k),
                 up = static_cast<double>(i / side % k) / static_cast<double>(k);
    all.push_back((1 - up) * ((1 - right) * at(x, y) + right * at(x + 1, y)) +
                  up * ((1 - right) * at(x, y + 1) + right * at(x + 1, y + 1)));
  }
  return all;
}

// One surface, or one above another; in half of the cases with a floor that is just reached, or not yet, or well. At 0 the
// highest point touches.
Problem random_problem(unsigned seed) {
  ::scenes::Random random(seed, 1);
  Problem problem;
  problem.system.boundary = random.chance(0.25) ? RC_BOUNDARY_PERIODIC : RC_BOUNDARY_FREE;
  problem.system.nx = problem.system.ny = side;
  Field z = random_surface(random);
  if (random.chance(0.25)) {
    const double scale = random.decades(-1, 1), lower = random.uniform();
    const Field other = random_surface(random);
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = std::max(z[i], scale * other[i] - lower);
  }
  const double top = *std::ranges::max_element(z), floor = random.chance(0.5) ? random.decades(-1.5, -0.1) : HUGE_VAL;
  double mean = 0;
  for (const double each : z) {
    problem.gap.push_back(std::min(top - each, floor));
    mean += problem.gap.back() / static_cast<double>(side * side);
  }
  const double depth = floor < HUGE_VAL ? 2 * floor * random.decades(-0.3, 0.3) : mean * random.uniform(0.1, 1);
  problem.target = problem.periodic() ? std::min(depth, 0.9 * mean) : depth;
  return problem;
}

struct Count {
  int asked = 0, coarser = 0, beyond = 0;
  double worst = 0;  // error over goal
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
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const Problem problem = random_problem(seed);
    const Answer exact = solved(problem, automatic, {{RC_OPT_TOL, "1e-8"}});
    if (exact.result.load == 0) continue;
    count(problem, exact, of_area, all.by_approach);
    count(at_load(problem, exact.result.load), exact, of_area, all.by_load);
  }
  accuracy::report("approach", all.by_approach);
  accuracy::report("load", all.by_load);
  return all;
}

void check_counts(const Counts& all, double allowed, double least_coarser) {
  for (const Count& each : {all.by_approach, all.by_load}) {
    check(each.beyond <= allowed * each.coarser, "hardly any coarser answer is beyond its goal");
    check(each.coarser >= least_coarser * each.asked, "coarser grids serve");
  }
}

void goals_of_the_load_are_met() {
  const Counts all = count_all(false, quick() ? 40 : 800);
  if (!quick()) check(all.by_approach.coarser >= 1000 && all.by_load.coarser >= 1000, "2000 coarser answers");
  check_counts(all, 0.005, 0.2);
}

void goals_of_the_area_are_met() { check_counts(count_all(true, quick() ? 40 : 130), 0.03, 0.02); }

}  // namespace

std::vector<Test> statistics_tests() { return RC_TESTS(goals_of_the_load_are_met, goals_of_the_area_are_met); }

}  // namespace accuracy
