// A history that is continued in a new contact gives the bits of one that is not interrupted.
#include <roughcontact/history.h>

#include "history.h"
#include "path_tests.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace paths {

namespace {

using namespace pairs;

const Field fractions = {0.3, 0.6, 0.62, 0, 1, 0.5};

// After step number `step` of answers or of what a path's fn saw.
template <class Step>
void restore(const Contact& contact, const Problem& problem, const std::vector<Step>& steps, std::size_t step) {
  rc_state state = RC_STATE_INIT;
  state.undeformed_gap = RC_IN(problem.gap.data());
  state.mask = RC_IN(problem.mask.empty() ? nullptr : problem.mask.data());
  const Step& last = steps[step];
  state.p = RC_IN(last.p.data());
  state.approach = last.result.approach;
  state.load = last.result.load;
  if (step > 0) {
    const Step& before = steps[step - 1];
    state.p_before = RC_IN(before.p.data());
    state.approach_before = before.result.approach;
    state.load_before = before.result.load;
  }
  check(rc_contact_restore(contact.handle(), &state) == RC_OK, rc_last_error());
}

Field scaled(double top) {
  Field targets = fractions;
  for (double& each : targets) each *= top;
  return targets;
}

// Answers without a gap: only points that matter are looked at.
std::vector<Answer> answers(const Contact& contact, const Problem& problem, const Field& targets, bool with_surface) {
  std::vector<Answer> found;
  for (const double target : targets) {
    rc_step step = problem.step();
    step.target = target;
    if (!with_surface || !found.empty()) step.undeformed_gap.data = nullptr, step.mask.data = nullptr;
    Answer answer;
    answer.p.assign(problem.points(), 0);
    answer.result = RC_RESULT_INIT;
    answer.result.p.data = answer.p.data();
    answer.status = rc_contact_solve(contact.handle(), &step, &answer.result);
    check(answer.status == RC_OK || answer.status == RC_WITHIN_GOAL, rc_last_error());
    found.push_back(std::move(answer));
  }
  return found;
}

// Where contacts of coarser grids, screening and goals take part.
void larger_grids_give_the_same_bits(std::int64_t side, const Pair& pair, const Settings& more) {
  Settings settings{{RC_OPT_RESUMABLE, "1"}, {RC_OPT_TOL, "1e-6"}};
  settings.insert(settings.end(), more.begin(), more.end());
  const Problem problem = rough_problem(side, side, RC_BOUNDARY_FREE, 1, 1);
  const Field targets = scaled(0.1 * problem.target);
  const std::vector<Answer> whole = answers(Contact(problem, pair, settings), problem, targets, true);
  for (std::size_t cut = 1; cut < targets.size(); cut += 2) {
    const Contact contact(problem, pair, settings);
    restore(contact, problem, whole, cut - 1);
    const Field rest(targets.begin() + static_cast<std::ptrdiff_t>(cut), targets.end());
    const std::vector<Answer> part = answers(contact, problem, rest, false);
    for (std::size_t i = 0; i < part.size(); ++i) {
      pairs::check_same(part[i].p, whole[cut + i].p, "p");
      check_equal(part[i].result.load, whole[cut + i].result.load, "load");
      check_equal(part[i].result.products, whole[cut + i].result.products, "products");
    }
  }
}

}  // namespace

std::vector<Test> restored_tests() {
  std::vector<Test> tests;
  const auto add_larger = [&](const char* name, std::int64_t side, const Pair& pair, const Settings& settings) {
    tests.push_back({std::string("restored/") + name, [=] { larger_grids_give_the_same_bits(side, pair, settings); }});
  };
  add_larger("automatic", 160, automatic, {});
  add_larger("nested", 160, {"haar-cg", "fft"}, {});
  add_larger("cascade", 160, {"cmr", "fft"}, {});
  add_larger("goal", 160, {"auto", "fft"}, {{RC_OPT_ACCURACY, "0.1"}});
  add_larger("few_points", 512, {"haar-cg", "split"}, {});
  return tests;
}

}  // namespace paths
