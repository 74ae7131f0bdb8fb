// A path gives the same bits as rc_contact_solve called for each of its steps, for every solver on every backend.
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

struct Order {
  const char* name;
  Field fractions;  // of the largest target
};

const Order orders[] = {
    {"increasing", {0.2, 0.5, 0.8, 1}}, {"decreasing", {1, 0.7, 0.3, 0.1}}, {"mixed", {0.6, 0.2, 1, 0.9, 0, 0.5}}};

Field scaled(const Field& fractions, double top) {
  Field targets;
  for (const double each : fractions) targets.push_back(each * top);
  return targets;
}

// One call a step on a contact of its own.
History step_by_step(const Problem& problem, const Pair& pair, const Request& request) {
  const Contact contact(problem, pair, complete(pair, {{RC_OPT_STIFFNESS, "1"}}));
  History history;
  rc_step step = problem.step();
  step.control = request.control;
  step.warm_start = request.warm_start;
  for (const double target : request.targets) {
    step.target = target;
    const Answer answer = contact.solve(step);
    pairs::check_status(answer, RC_OK);
    history.load.push_back(answer.result.load);
    history.approach.push_back(answer.result.approach);
    history.contact_area.push_back(answer.result.contact_area);
    history.stiffness.push_back(answer.result.stiffness);
    history.certificate.push_back(answer.worst_residual());
    history.products.push_back(answer.result.products);
    history.seen.push_back({answer.result, answer.p, answer.gap});
  }
  return history;
}

void equals_steps(std::int32_t boundary, const Order& order, const Pair& pair) {
  const Problem problem = rough_problem(18, 14, boundary, 0.5, 0.75);
  const double load = solved(problem, automatic).result.load;
  for (const std::int32_t control : controls)
    for (const std::int32_t warm : {1, 0}) {
      Request request;
      request.control = control;
      request.warm_start = warm;
      request.targets = scaled(order.fractions, control == RC_CONTROL_LOAD ? load : problem.target);
      const History path = followed(Contact(problem, pair, complete(pair)), problem, request);
      check_same(path, step_by_step(problem, pair, request), 0, request.targets.size());
      for (const double residual : path.certificate) check(residual <= 1e-12, "residual " + text(residual));
    }
}

void fn_sees_what_is_written(std::int32_t boundary, const Pair& pair) {
  Problem problem = rough_problem(18, 14, boundary, 0.5, 0.75);
  problem.mask.assign(problem.points(), 1);
  const auto highest = static_cast<std::size_t>(std::min_element(problem.gap.begin(), problem.gap.end()) - problem.gap.begin());
  problem.mask[highest] = 0;
  Request request;
  request.targets = scaled(orders[0].fractions, problem.target);
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
  const Field targets = scaled(orders[0].fractions, problem.target);
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
  request.targets = scaled(orders[0].fractions, problem.target);
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

void fn_sees_the_gap_if_it_is_wanted() {
  const Problem problem = rough_problem(18, 14, RC_BOUNDARY_FREE, 1, 1);
  Request request;
  request.targets = scaled(orders[0].fractions, problem.target);
  const History with = followed(Contact(problem, automatic), problem, request);
  request.want_gap = false;
  const History without = followed(Contact(problem, automatic), problem, request);
  for (std::size_t i = 0; i < request.targets.size(); ++i) {
    check(with.seen[i].gap.size() == problem.points() && without.seen[i].gap.empty(), "which has the gap");
    pairs::check_same(without.seen[i].p, with.seen[i].p, "p");
    check(with.seen[i].result.mean_gap > 0, "the mean gap is known with the gap");
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
    for (const Order& order : orders)
      if (!quick() || &order == &orders[2])
        add_for_pairs(tests, std::string(order.name) + "_path_equals_its_steps", boundary,
                      [boundary, &order](const Pair& pair) { equals_steps(boundary, order, pair); });
    add_for_pairs(tests, "fn_sees_what_is_written", boundary,
                  [boundary](const Pair& pair) { fn_sees_what_is_written(boundary, pair); });
  }
  tests.push_back({"outputs_may_be_null", outputs_may_be_null});
  tests.push_back({"stiffness_is_computed_where_it_is_asked_for", stiffness_is_computed_where_it_is_asked_for});
  tests.push_back({"fn_sees_the_gap_if_it_is_wanted", fn_sees_the_gap_if_it_is_wanted});
  tests.push_back({"no_steps_change_nothing", no_steps_change_nothing});
  return tests;
}

}  // namespace paths
