// Figure 5: greedy elimination with conjugate gradients, a Cholesky factor, and Gauss & Seidel's method, against the number of
// candidates.
#include <algorithm>

#include "cold_solve.h"
#include "failure_scenes.h"
#include "library.h"
#include "paper.h"
#include "stopwatch.h"

namespace bench {

namespace {

constexpr double budget = 0.3;  // seconds for repeats of a solve
constexpr std::size_t most_repeats = 20;

// Processor time until the first iteration: Gauss & Seidel's method stores the matrix before it.
struct FirstIteration {
  double cpu = 0;
  static int32_t seen(const rc_progress*, void* user) {
    auto& first = *static_cast<FirstIteration*>(user);
    if (first.cpu == 0) first.cpu = cpu_seconds();
    return 0;
  }
};

Json measure(std::int64_t levels, std::int64_t n, const std::string& inner, std::uint64_t seed) {
  Scene scene = rough_scene(levels, seed);
  Field sorted = scene.gap;
  const auto last = sorted.begin() + n;
  std::nth_element(sorted.begin(), last, sorted.end());
  scene.approach = *last;  // n points are nearer
  scene.kernel = "eq9";
  Options options;
  options.set({{RC_OPT_SOLVER, "greedy"},
               {"greedy.inner", inner},
               {RC_OPT_BACKEND, "dense"},
               {RC_OPT_KERNEL, scene.kernel},
               {RC_OPT_TOL, "1e-8"},
               {RC_OPT_MAX_ITER, "100000"},
               {RC_OPT_BOUNDS, "0"}});
  std::vector<double> cpu, storing;
  rc_result result{};
  const auto begun = Clock::now();
  do {
    FirstIteration first;
    const double before = cpu_seconds();
    Contact contact(scene.system, options);
    contact.watch(FirstIteration::seen, &first);
    result = contact.solve(scene.step());
    cpu.push_back(cpu_seconds() - before);
    storing.push_back(first.cpu - before);
  } while (cpu.size() < most_repeats && seconds_since(begun) < budget);
  Json row = {{"candidates", result.candidates},        {"contacts", result.contacts},
              {"cpu_seconds", median_of(cpu)},          {"repeats", cpu.size()},
              {"iterations", result.iterations},        {"products", result.applications},
              {"status", rc_status_name(result.status)}};
  if (inner == "gauss-seidel") row["storing_seconds"] = median_of(storing);
  return row;
}

}  // namespace

void plan_figure_5(const PaperRequest& request, Plan& plan) {
  const std::vector<std::int64_t> sizes =
      request.quick ? std::vector<std::int64_t>{100, 300} : std::vector<std::int64_t>{250, 500, 1000, 2000, 4000};
  constexpr std::int64_t largest_sweep = 2000;  // the matrix is stored by n products
  const std::int64_t levels = request.quick ? 7 : 9;
  const std::uint64_t seeds = request.quick ? 2 : 6;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed)
    for (const std::int64_t n : sizes)
      for (const std::string inner : {"cg", "cholesky", "gauss-seidel"}) {
        const bool sweeps = inner == "gauss-seidel";
        if (sweeps && n > largest_sweep) continue;
        const double side = static_cast<double>(n) / 1000;
        plan.push_back(
            {"figure_5", {{"n", n}, {"inner", inner}, {"seed", seed}}, 0.4 + (sweeps ? 1.0 : 0.1) * side * side * side, [=] {
               return measure(levels, n, inner, seed);
             }});
      }
}

}  // namespace bench
