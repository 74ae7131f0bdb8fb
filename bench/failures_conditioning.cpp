// The family conditioning of the atlas: problems that strain double precision, by every solver of the registry.
#include <algorithm>
#include <map>

#include "failure_run.h"
#include "failures.h"
#include "format.h"
#include "library.h"

namespace bench {

namespace {

constexpr double right = 1e-4;  // of the largest pressure: a certified answer is at least that near

}  // namespace

void conditioning_failures(const FailuresRequest& request, Atlas& atlas) {
  const std::vector<std::string> solvers = solver_names();
  for (const Scene& scene : strained_scenes(request.quick ? 16 : 32)) {
    const Solved truth = truth_of(scene);
    std::string found, refused;
    long long wrong = 0, certified = 0;
    double worst = 0;
    for (const std::string& solver : solvers) {
      if (!runs(solver, "dense", scene)) continue;
      const Solved solved =
          solve(scene, {{"solver", solver}, {"backend", "dense"}, {"max_iter", "100000"}, {"time_limit", "60"}});
      const double error = solved.status < 0 ? 1 : difference(solved.p, truth.p);
      atlas.record("conditioning", {{"scene", scene.name},
                                    {"solver", solver},
                                    {"status", solved.name()},
                                    {"iterations", solved.iterations()},
                                    {"residual", solved.residual()},
                                    {"difference", error}});
      if (solved.status == RC_OK) {
        ++certified;
        worst = std::max(worst, error);
        wrong += error > right;
      } else {
        refused += (refused.empty() ? "" : ", ") + solver + " " + solved.name();
      }
      found += (found.empty() ? "" : ", ") + solver + formatted(" %lld", solved.iterations());
    }
    atlas.add(
        "conditioning",
        {scene.name, "iterations: " + found + formatted("; pressures of certified answers are off by %.1e at most", worst),
         formatted("certified %lld, wrong with status RC_OK %lld", certified, wrong) + (refused.empty() ? "" : "; " + refused),
         refused.empty() ? "nothing to do" : "another solver certifies it; auto never chooses those that cannot"});
  }
  std::string growth;
  for (const char* kernel : {"eq9", "love"})
    for (std::int64_t levels = 4; levels <= (request.quick ? 6 : 8); ++levels) {
      Scene scene = rough_scene(levels, 1);
      scene.kernel = kernel;
      scene.approach *= 3;
      const Solved solved = solve(scene, {{"solver", "polonsky-keer"}, {"backend", "fft"}, {"max_iter", "100000"}});
      atlas.record("kernel_cost", {{"kernel", kernel},
                                   {"side", scene.system.nx},
                                   {"iterations", solved.iterations()},
                                   {"products", solved.products()},
                                   {"status", solved.name()}});
      growth += formatted("%s%s %lld^2: %lld", growth.empty() ? "" : ", ", kernel, static_cast<long long>(scene.system.nx),
                          solved.products());
    }
  atlas.add("conditioning", {"kernel eq9, whose diagonal is 36 % too small, against love on finer and finer surfaces",
                             "products of polonsky-keer: " + growth, "certified either way", "kernel love is the default"});
}

}  // namespace bench
