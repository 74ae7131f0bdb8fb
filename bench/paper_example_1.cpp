// Example 1 and figure 2: where greedy elimination goes wrong, and the smooth shapes on which it is said never to.
#include <algorithm>
#include <cmath>
#include <random>

#include "failure_run.h"
#include "greedy_draws.h"
#include "paper.h"

namespace bench {

namespace {

// Figure 2: the first draw of 100 points that greedy gets wrong.
Json first_wrong_draw() {
  constexpr std::int64_t side = 10;
  for (std::uint64_t seed = 0;; ++seed) {
    Scene scene = example_one(side, 1, seed);
    scene.kernel = "eq9";
    const Solved found = solve(scene, {{"solver", "greedy"}, {"backend", "dense"}, {"tol", "1e-10"}});
    if (found.status == RC_OK) continue;
    const Solved truth = solve(scene, {{"solver", "nnls"}, {"backend", "dense"}, {"tol", "1e-10"}});
    if (truth.status != RC_OK) throw Failure(truth.message);
    Field u, w(scene.gap.size(), 0.0), table(scene.gap.size());
    check(rc_kernel_coefficients("eq9", 1, 1, side, side, table.data()));
    for (std::int64_t i = 0; i < side * side; ++i) {
      const auto at = static_cast<std::size_t>(i);
      u.push_back(scene.approach - scene.gap[at]);
      w[at] = -u[at];
      for (std::int64_t j = 0; j < side * side; ++j) {
        const std::int64_t offset = std::abs(i / side - j / side) * side + std::abs(i % side - j % side);
        w[at] += table[static_cast<std::size_t>(offset)] * found.p[static_cast<std::size_t>(j)];
      }
    }
    return {{"seed", seed}, {"status", found.name()}, {"u", u}, {"w", w}, {"greedy", found.p}, {"exact", truth.p}};
  }
}

Json smooth(const Scene& scene) {
  const Solved found = solve(scene, {{"solver", "greedy"}, {"backend", "dense"}});
  return {{"draws", 1}, {"failures", found.status == RC_OK ? 0 : 1}, {"status", found.name()}, {"load", found.result.load}};
}

// Hertz: load 4/3 E* sqrt(R d^3), for a radius of curvature of n cells.
Json hertz(const std::string& kernel) {
  constexpr std::int64_t n = 96;
  Scene scene = hertz_scene(n);
  scene.kernel = kernel;
  Json row = smooth(scene);
  const double load = 4.0 / 3.0 * std::sqrt(static_cast<double>(n) * std::pow(scene.approach, 3));
  row["load_error"] = row.at("load").get<double>() / load - 1;
  return row;
}

Json flat_punch(const std::string& kernel) {
  Scene scene = hertz_scene(20);
  scene.kernel = kernel;
  std::fill(scene.gap.begin(), scene.gap.end(), 0.0);
  scene.approach = 1;
  return smooth(scene);
}

// Paraboloids whose tip lies anywhere between the points, contact radii of 3 to 9 cells.
Json spheres(const std::string& kernel, std::int64_t draws) {
  constexpr std::int64_t n = 24;
  std::mt19937_64 bits(1);
  const auto uniform = [&] { return std::ldexp(static_cast<double>(bits() >> 11), -53); };
  Scene scene = hertz_scene(n);
  scene.kernel = kernel;
  std::int64_t failures = 0;
  double deepest = 0;
  for (std::int64_t draw = 0; draw < draws; ++draw) {
    const double x0 = 0.5 * n - uniform(), y0 = 0.5 * n - uniform(), radius = 100, contact = 3 + 6 * uniform();
    for (std::int64_t i = 0; i < n * n; ++i) {
      const double x = static_cast<double>(i % n) - x0, y = static_cast<double>(i / n) - y0;
      scene.gap[static_cast<std::size_t>(i)] = (x * x + y * y) / (2 * radius);
    }
    scene.approach = contact * contact / radius;
    const Solved found =
        solve(scene, {{"solver", "greedy"}, {"greedy.inner", "cholesky"}, {"backend", "dense"}, {"tol", "1e-10"}});
    failures += found.status != RC_OK;
    deepest = std::max(deepest, found.result.kkt_dual);
  }
  return {{"draws", draws}, {"failures", failures}, {"deepest_overlap", deepest}};
}

}  // namespace

void plan_example_1(const PaperRequest& request, Plan& plan) {
  struct Draws {
    const char* kernel;
    std::int64_t side, spacing, draws, quick;
    double cost;  // seconds of one draw
  };
  const Draws all[] = {{"eq9", 5, 1, 10000, 1000, 3e-4}, {"eq9", 10, 1, 5000, 500, 1e-3},   {"eq9", 20, 1, 1000, 60, 1e-2},
                       {"eq9", 30, 1, 400, 0, 0.1},      {"eq9", 5, 2, 1000, 0, 3e-4},      {"eq9", 10, 2, 1000, 200, 1e-3},
                       {"eq9", 20, 2, 1000, 0, 1e-2},    {"love", 10, 1, 1000, 200, 1e-3},  {"punch", 10, 1, 1000, 200, 1e-3},
                       {"disc", 10, 1, 1000, 0, 1e-3},   {"galerkin", 10, 1, 1000, 0, 1e-3}};
  for (const Draws& each : all) {
    const std::int64_t draws = request.quick ? each.quick : each.draws;
    if (draws == 0) continue;
    plan.push_back({"example_1",
                    {{"kernel", each.kernel}, {"n", each.side * each.side}, {"spacing", each.spacing}, {"draws", draws}},
                    each.cost * static_cast<double>(draws),
                    [each, draws] { return greedy_on_draws(each.kernel, each.side, each.spacing, draws); }});
  }
  plan.push_back({"figure_2", {{"kernel", "eq9"}, {"n", 100}}, 0.1, first_wrong_draw});
  const std::int64_t draws = request.quick ? 60 : 2000;
  for (const std::string kernel : {"eq9", "love"}) {
    plan.push_back({"smooth", {{"shape", "sphere"}, {"kernel", kernel}}, 0.5, [kernel] { return hertz(kernel); }});
    plan.push_back({"smooth", {{"shape", "flat punch"}, {"kernel", kernel}}, 0.1, [kernel] { return flat_punch(kernel); }});
    plan.push_back({"smooth",
                    {{"shape", "spheres between the points"}, {"kernel", kernel}},
                    5e-3 * static_cast<double>(draws),
                    [kernel, draws] { return spheres(kernel, draws); }});
  }
}

}  // namespace bench
