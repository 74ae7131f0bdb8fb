// The host program's floating-point mode changes no answer and stays as it was: traps, rounding, flush to zero.
#include "invariance_tests.h"
#include "support/host_modes.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

using support::Found, support::InMode, support::Mode;

void check_same_in(const Mode& mode, const Problem& problem, const Pair& pair, const Settings& settings, const Answer& wanted) {
  Answer found;
  bool kept = false;
  {
    const InMode in_mode(mode);
    const Found given;
    found = solve(problem, pair, settings);
    kept = Found() == given;
  }
  check(kept, std::string("the call leaves another mode than ") + mode.name);
  check_status(found, RC_OK, mode.name);
  check_same(found.p, wanted.p, mode.name);
  check_same(found.gap, wanted.gap, mode.name);
  const rc_result &a = found.result, &b = wanted.result;
  check_same({a.load, a.approach, a.energy, a.stiffness, a.load_upper}, {b.load, b.approach, b.energy, b.stiffness, b.load_upper},
             mode.name);
}

void host_modes_change_nothing(std::int32_t boundary, const Pair& pair) {
  std::vector<Problem> problems = {rough_problem(24, 18, boundary, 0.5, 0.75)};
  problems[0].target *= 1.4;
  problems.push_back(at_load(problems[0], solved(problems[0], pair).result.load));
  for (const char* threads : {"1", "2"})
    for (const Problem& problem : problems) {
      const Settings settings = {{RC_OPT_THREADS, threads}, {RC_OPT_STIFFNESS, "1"}};
      const Answer wanted = solved(problem, pair, settings);
      for (const Mode& mode : support::modes) check_same_in(mode, problem, pair, settings, wanted);
    }
}

}  // namespace

std::vector<Test> arithmetic_tests() {
  std::vector<Test> tests;
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
    add_for_pairs(tests, "the_hosts_floating_point_mode_changes_nothing", boundary,
                  [=](const Pair& pair) { host_modes_change_nothing(boundary, pair); });
  return tests;
}

}  // namespace pairs
