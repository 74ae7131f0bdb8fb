// A path writes every output and shows every step to its callback. Scenes compare its steps with single steps.
#include <roughcontact/history.h>

#include <algorithm>
#include <cmath>

#include "history.h"
#include "path_tests.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace paths {

namespace {

using namespace pairs;

const Field rising = {0.2, 0.5, 0.8, 1};  // of the largest target

Field scaled(const Field& fractions, double top) {
  Field targets;
  for (const double each : fractions) targets.push_back(each * top);
  return targets;
}

void fn_sees_what_is_written(std::int32_t boundary, const Pair& pair) {
  Problem problem = rough_problem(18, 14, boundary, 0.5, 0.75);
  problem.mask.assign(problem.points(), 1);
  const auto highest = static_cast<std::size_t>(std::min_element(problem.gap.begin(), problem.gap.end()) - problem.gap.begin());
  problem.mask[highest] = 0;
  Request request;
  request.targets = scaled(rising, problem.target);
  const History path = followed(Contact(problem, pair, complete(pair)), problem, request);
  for (std::size_t i = 0; i < request.targets.size(); ++i) {
    const rc_result& r = path.seen[i].result;
    check_equal(r.status, RC_OK, "status");
    check(r.approach == request.targets[i] && r.approach == path.approach[i], "another step's result");
    check(r.load == path.load[i] && r.products == path.products[i], "result and outputs differ");
    check_near(sum(path.seen[i].p) * problem.cell_area(), r.load, 1e-12 * r.load, "force of the pressures");
    check(path.seen[i].p[highest] == 0, "pressure under the mask");
    for (std::size_t k = 0; k < problem.points(); ++k)
      if (path.seen[i].p[k] > 0) check(std::abs(path.seen[i].gap[k]) < 1e-9, "gap in contact");
  }
}

void outputs_may_be_null() {
  const Problem problem = rough_problem(18, 14, RC_BOUNDARY_FREE, 1, 1);
  const Contact contact(problem, automatic);
  const Field targets = scaled(rising, problem.target);
  rc_history path = RC_HISTORY_INIT;
  path.control = RC_CONTROL_APPROACH;
  path.n = static_cast<std::int64_t>(targets.size());
  path.targets = RC_IN(targets.data());
  path.undeformed_gap = RC_IN(problem.gap.data());
  check(rc_contact_solve_history(contact.handle(), &path) == RC_OK, rc_last_error());
  check_equal(path.completed, path.n, "completed steps");
  rc_step step = problem.step();
  step.undeformed_gap.data = nullptr;
  const Answer last = contact.solve(step);
  pairs::check_status(last, RC_OK);
  check_near(last.p, solved(problem, automatic).p, 1e-9, "p of the step after");
}

void stiffness_is_computed_where_it_is_asked_for() {
  const Problem problem = rough_problem(18, 14, RC_BOUNDARY_FREE, 1, 1);
  Request request;
  request.targets = scaled(rising, problem.target);
  for (const char* option : {"0", "1"}) {
    const Contact contact(problem, automatic, {{RC_OPT_STIFFNESS, option}});
    for (const bool with : {true, false}) {
      request.with_stiffness = with;
      const History path = followed(contact, problem, request);
      for (std::size_t i = 0; i < request.targets.size(); ++i) {
        check(with ? path.stiffness[i] > 0 : path.stiffness[i] == blank, "stiffness written");
        check(std::isnan(path.seen[i].result.stiffness) == (!with && *option == '0'), "stiffness of the result");
      }
      check(std::isnan(contact.solve(problem).result.stiffness) == (*option == '0'), "option stiffness after the path");
    }
  }
}

void no_steps_change_nothing() {
  const Problem problem = rough_problem(18, 14, RC_BOUNDARY_FREE, 1, 1);
  const Contact contact(problem, automatic), other(problem, automatic);
  const Answer first = contact.solve(problem);
  pairs::check_status(first, RC_OK);
  pairs::check_status(other.solve(problem), RC_OK);
  followed(contact, problem, Request{});
  rc_step step = problem.step();
  step.undeformed_gap.data = nullptr;
  step.target *= 1.1;
  pairs::check_same(contact.solve(step).p, other.solve(step).p, "p after an empty path");
}

}  // namespace

std::vector<Test> against_steps_tests() {
  std::vector<Test> tests;
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    add_for_pairs(tests, "fn_sees_what_is_written", boundary,
                  [boundary](const Pair& pair) { fn_sees_what_is_written(boundary, pair); });
  }
  tests.push_back({"outputs_may_be_null", outputs_may_be_null});
  tests.push_back({"stiffness_is_computed_where_it_is_asked_for", stiffness_is_computed_where_it_is_asked_for});
  tests.push_back({"no_steps_change_nothing", no_steps_change_nothing});
  return tests;
}

}  // namespace paths
