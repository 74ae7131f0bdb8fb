// Example 1 of Bemporad & Paggi (2015): N x N cells, all of them candidates, compenetrations uniform on (0, 1).
#include <cstdio>

#include "failure_scenes.h"
#include "failures.h"
#include "format.h"
#include "inverse_m.h"
#include "library.h"
#include "wilson.h"

namespace bench {

namespace {

constexpr const char* kernels[] = {"eq9", "punch", "galerkin", "love", "disc"};

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

Json measure(const std::string& kernel, std::int64_t side, std::int64_t spacing, std::int64_t draws) {
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

}  // namespace

void greedy_failures(const FailuresRequest& request, Atlas& atlas) {
  std::string shares;
  Json worst;
  std::int64_t elsewhere = 0, elsewhere_draws = 0, dishonest = 0, unrepaired = 0;
  for (const char* kernel : kernels)
    for (const std::int64_t spacing : {1, 2})
      for (const std::int64_t side : {5, 10, 20}) {
        const std::int64_t draws = !request.quick ? 1000 : side < 20 ? 100 : 30;
        const Json row = measure(kernel, side, spacing, draws);
        atlas.record("greedy", row);
        dishonest += row.at("dishonest").get<std::int64_t>();
        unrepaired += row.at("unrepaired").get<std::int64_t>();
        if (row.at("kernel") != "eq9" || spacing != 1) {
          elsewhere += row.at("failures").get<std::int64_t>();
          elsewhere_draws += draws;
          continue;
        }
        shares +=
            (shares.empty() ? "" : "; ") + formatted("n = %lld: %.1f %% (%.1f to %.1f)", static_cast<long long>(side * side),
                                                     100 * row.at("share").get<double>(), 100 * row.at("lower").get<double>(),
                                                     100 * row.at("upper").get<double>());
        if (side == 10) worst = row;
      }
  atlas.add(
      "greedy",
      {"Example 1 of the paper: N x N cells in contact at random depths, kernel eq9",
       "the answer overlaps in a share of draws that grows with n, " + shares +
           formatted(
               "; at n = 100 the deepest overlap is %.2f of the compenetration, loads are off by up to %.1e and pressures by "
               "up to %.0f %% of the largest",
               worst.at("deepest_overlap").get<double>(), worst.at("load_error").get<double>(),
               100 * worst.at("pressure_error").get<double>()),
       formatted(
           "RC_STOP_UNCERTIFIED with a note that counts the overlapping points, in each of the draws; wrong answers with status "
           "RC_OK: %lld",
           static_cast<long long>(dishonest)),
       formatted(
           "every other solver lets points come back; greedy.repair = 1 hands what greedy found over to nnls: draws it left "
           "unsolved: %lld",
           static_cast<long long>(unrepaired))});
  atlas.add("greedy",
            {"the same with kernels love, disc, galerkin or punch, or with every second cell left out",
             formatted("%lld of %lld draws fail", static_cast<long long>(elsewhere), static_cast<long long>(elsewhere_draws)),
             "not needed, checked all the same", "kernel love is the default"});

  std::string couplings;
  for (const char* kernel : kernels) {
    double dense = 0;
    for (const std::int64_t spacing : {1, 2})
      for (const std::int64_t side : {5, 10, 20, 30}) {
        if (side > 20 && (request.quick || spacing > 1)) continue;
        const double coupling = largest_inverse_coupling(kernel, side, spacing);
        atlas.record("inverse", {{"kernel", kernel}, {"n", side * side}, {"spacing", spacing}, {"coupling", coupling}});
        if (spacing == 1) dense = coupling;
      }
    couplings += formatted("%s%s %+.1e", couplings.empty() ? "" : ", ", kernel, dense);
  }
  atlas.add("greedy", {"why: greedy is exact for every surface if and only if H^-1 has no positive entry off its diagonal",
                       "largest such entry over the smallest on the diagonal: " + couplings +
                           "; negative for every kernel when every second cell is left out",
                       "a property of kernel and grid, tabled as \"inverse\"",
                       "galerkin and punch are exact on random surfaces only; see docs/paper.md"});
}

}  // namespace bench
