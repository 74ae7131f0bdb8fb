// Hundreds of steps up and down in random order: every one of them gives what a cold solve gives there.
#include <algorithm>
#include <map>
#include <random>

#include "history.h"
#include "support/registry.h"
#include "support/surfaces.h"
#include "support/unit_system.h"

namespace paths {

namespace {

using namespace pairs;

constexpr double accurate = 1e-6;  // |p - p of the cold solve| / max p; both are certified to 1e-8 or better

std::size_t steps() { return quick() ? 15 : 200; }

struct Reference {
  Problem problem;
  Request request;
  std::vector<Answer> cold;
};

// From no contact at all to the deepest approach; half of the steps are small changes of the one before.
Field random_targets(double top, unsigned seed) {
  std::mt19937 generator(seed);
  const auto uniform = [&] { return static_cast<double>(generator()) / 4294967296.0; };
  Field targets;
  double fraction = 0.5;
  for (std::size_t i = 0; i < steps(); ++i) {
    fraction = uniform() < 0.5 ? uniform() : std::clamp(fraction + 0.1 * (uniform() - 0.5), 0.0, 1.0);
    targets.push_back(fraction * top);
  }
  return targets;
}

const Reference& reference(std::int32_t boundary, std::int32_t control) {
  static std::map<std::pair<std::int32_t, std::int32_t>, Reference> made;
  const auto [it, fresh] = made.try_emplace({boundary, control});
  Reference& r = it->second;
  if (!fresh) return r;
  const std::int64_t side = quick() ? 16 : 32;
  r.problem = rough_problem(side, side, boundary, 1, 1);
  r.problem.target *= boundary == RC_BOUNDARY_PERIODIC ? 1.8 : 1.4;
  r.request.control = control;
  r.request.with_stiffness = false;
  const double top = control == RC_CONTROL_LOAD ? solved(r.problem, automatic).result.load : r.problem.target;
  r.request.targets = random_targets(top, 11);
  const Contact contact(r.problem, {"polonsky-keer", "auto"}, {{RC_OPT_TOL, "1e-10"}});
  rc_step step = r.problem.step();
  step.control = control;
  step.warm_start = 0;
  for (const double target : r.request.targets) {
    step.target = target;
    r.cold.push_back(contact.solve(step));
    pairs::check_status(r.cold.back(), RC_OK, "cold");
  }
  return r;
}

void agrees_with_cold_solves(std::int32_t boundary, std::int32_t control, const std::string& solver) {
  const Reference& r = reference(boundary, control);
  const Pair pair{solver, "auto"};
  const Contact contact(r.problem, pair, complete(pair, {{RC_OPT_TOL, "1e-8"}, {RC_OPT_MAX_ITER, "1000000"}}));
  const History path = followed(contact, r.problem, r.request);
  const double deepest = largest(r.problem.gap), heaviest = largest(path.load);
  for (std::size_t i = 0; i < r.cold.size(); ++i) {
    check_near(path.seen[i].p, r.cold[i].p, accurate, "step " + std::to_string(i) + ": p");
    check_near(path.load[i], r.cold[i].result.load, accurate * heaviest, "step " + std::to_string(i) + ": load");
    check_near(path.approach[i], r.cold[i].result.approach, accurate * deepest, "step " + std::to_string(i) + ": approach");
    check(path.certificate[i] <= 1e-8, "certificate");
  }
}

std::vector<Test> tests() {
  std::vector<Test> result;
  for (const std::string& solver : solver_names())
    for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
      for (const std::int32_t control : controls) {
        rc_system system = support::unit_system();
        system.boundary = boundary;
        if (!obstacle({solver, "auto"}, system, control).empty() && !obstacle({solver, "dense"}, system, control).empty())
          continue;
        result.push_back({solver + "/" + kind_of(system) + "/" + (control == RC_CONTROL_LOAD ? "load" : "approach"),
                          [=] { agrees_with_cold_solves(boundary, control, solver); }});
      }
  return result;
}

}  // namespace

}  // namespace paths

int main(int argc, char** argv) { return pairs::run_group("paths_random", paths::tests(), argc, argv); }
