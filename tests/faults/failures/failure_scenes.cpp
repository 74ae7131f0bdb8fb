#include "failure_scenes.h"

#include <algorithm>

#include "rough_surface.h"
#include "scenes/random.h"
#include "support/surfaces.h"

namespace failures {

namespace {

Problem on_grid(std::int64_t n) {
  Problem problem;
  problem.kernel = "love";
  problem.system.nx = problem.system.ny = n;
  return problem;
}

std::int64_t power_of_two(std::int64_t n) {
  std::int64_t levels = 0;
  while ((std::int64_t{1} << levels) < n) ++levels;
  return levels;
}

}  // namespace

Problem example_one(std::int64_t side, std::int64_t spacing, std::uint64_t seed) {
  const std::int64_t width = spacing * (side - 1) + 1;
  Problem problem = on_grid(width);
  problem.target = 1;
  problem.gap.assign(problem.points(), 2.0);
  if (spacing > 1) problem.mask.assign(problem.points(), 0);
  scenes::Random random(seed, 1);
  for (std::int64_t iy = 0; iy < side; ++iy)
    for (std::int64_t ix = 0; ix < side; ++ix) {
      const auto i = static_cast<std::size_t>(spacing * (iy * width + ix));
      problem.gap[i] = 1 - random.uniform();
      if (spacing > 1) problem.mask[i] = 1;
    }
  return problem;
}

Problem hertz_problem(std::int64_t n) {
  Problem problem = on_grid(n);
  const double middle = 0.5 * static_cast<double>(n - 1), radius = static_cast<double>(n);
  problem.gap = paraboloid(n, n, 1, middle, middle, radius);
  problem.target = radius / 9;
  return problem;
}

Problem midpoint_problem(std::int64_t levels, std::uint64_t seed) {
  Problem problem = on_grid(std::int64_t{1} << levels);
  problem.gap = gap_below_highest(midpoint_surface(levels, 0.7, seed));
  problem.target = mean_of(problem.gap) / 2;
  return problem;
}

std::vector<std::pair<std::string, Problem>> strained_problems(std::int64_t n) {
  const Problem rough = midpoint_problem(power_of_two(n), 3);
  const double highest = *std::max_element(rough.gap.begin(), rough.gap.end());
  std::vector<std::pair<std::string, Problem>> all;
  const auto add = [&](const char* name, const Problem& problem) -> Problem& { return all.emplace_back(name, problem).second; };
  add("rough, kernel eq9", rough).kernel = "eq9";
  add("nearly every point in contact", rough).target = 40 * highest;
  {
    Problem& problem = add("one point touches", rough);
    Field sorted = rough.gap;
    std::nth_element(sorted.begin(), sorted.begin() + 1, sorted.end());
    problem.target = 0.5 * sorted[1];
  }
  {
    Problem& problem = add("a spike of 1e3 times the roughness", rough);
    for (double& value : problem.gap) value += 1e3 * highest;
    problem.gap[problem.gap.size() / 2 + 5] = 0;
    problem.target = 1e3 * highest + rough.target;
  }
  {
    Problem& problem = add("heights around 1e6 times the roughness", rough);
    for (double& value : problem.gap) value += 1e6 * highest;
    problem.target = 1e6 * highest + rough.target;
  }
  {
    Problem& problem = add("flat but for 1e-9 of the approach", rough);
    for (double& value : problem.gap) value *= 1e-9 / highest;
    problem.target = 1;
  }
  add("cells 100 times as long as wide", rough).system.hx = 100;
  return all;
}

}  // namespace failures
