#include "greedy_draws.h"

#include <algorithm>
#include <cmath>

#include "failure_scenes.h"
#include "library.h"
#include "wilson.h"

namespace bench {

namespace {

struct Damage {
  std::int64_t failures = 0, dishonest = 0, unrepaired = 0;  // dishonest: certified, but not the solution, or the reverse
  double deepest = 0, load_error = 0, pressure_error = 0;
};

// Compares greedy with nnls, both certified or not by the library.
void add_draw(const Scene& scene, Contact& greedy, Contact& repairing, Contact& exact, Damage& damage) {
  rc_step step = RC_STEP_INIT;
  step.target = scene.approach;
  step.gap = scene.gap.data();
  step.mask = scene.mask.empty() ? nullptr : scene.mask.data();
  step.warm_start = 0;
  Field p(scene.gap.size()), truth(scene.gap.size());
  const rc_result found = greedy.solve(step, p.data()), known = exact.solve(step, truth.data());
  if (known.status != RC_OK) throw Failure(std::string("nnls: ") + rc_status_name(known.status));
  double difference = 0, largest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    difference = std::max(difference, std::abs(p[i] - truth[i]));
    largest = std::max(largest, truth[i]);
  }
  const bool wrong = difference > 1e-6 * largest;
  damage.dishonest += wrong == (found.status == RC_OK);
  damage.failures += found.status != RC_OK;
  if (found.status != RC_OK) damage.unrepaired += repairing.solve(step).status != RC_OK;
  damage.deepest = std::max(damage.deepest, found.kkt_dual);
  damage.load_error = std::max(damage.load_error, std::abs(found.load / known.load - 1));
  damage.pressure_error = std::max(damage.pressure_error, difference / largest);
}

}  // namespace

Json greedy_on_draws(const std::string& kernel, std::int64_t side, std::int64_t spacing, std::int64_t draws) {
  Damage damage;
  const rc_system system = example_one(side, spacing, 0).system;
  Options options;
  options.set(RC_OPT_KERNEL, kernel).set(RC_OPT_BACKEND, "dense").set(RC_OPT_TOL, 1e-10);
  options.set(RC_OPT_SOLVER, "nnls");
  Contact exact(system, options);
  Contact greedy(system, options.set(RC_OPT_SOLVER, "greedy").set("greedy.inner", "cholesky"));
  Contact repairing(system, options.set("greedy.repair", "1"));
  for (std::int64_t seed = 0; seed < draws; ++seed)
    add_draw(example_one(side, spacing, static_cast<std::uint64_t>(seed)), greedy, repairing, exact, damage);
  const Interval interval = wilson(damage.failures, draws);
  return {{"kernel", kernel},
          {"n", side * side},
          {"spacing", spacing},
          {"draws", draws},
          {"failures", damage.failures},
          {"share", static_cast<double>(damage.failures) / static_cast<double>(draws)},
          {"lower", interval.lower},
          {"upper", interval.upper},
          {"dishonest", damage.dishonest},
          {"unrepaired", damage.unrepaired},
          {"deepest_overlap", damage.deepest},
          {"load_error", damage.load_error},
          {"pressure_error", damage.pressure_error}};
}

}  // namespace bench
