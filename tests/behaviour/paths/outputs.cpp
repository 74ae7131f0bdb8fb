// Outputs of histories and batches that are asked for alone, and what a callback may ask for.
#include <roughcontact/history.h>

#include <cmath>
#include <limits>
#include <string>

#include "path_tests.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace paths {

namespace {

using namespace pairs;

struct Output {
  const char* name;
  rc_array rc_columns::*column;
  double rc_result::*of_result;
};

const Output outputs[] = {{"load", &rc_columns::load, &rc_result::load},
                          {"approach", &rc_columns::approach, &rc_result::approach},
                          {"contact_area", &rc_columns::contact_area, &rc_result::contact_area},
                          {"mean_gap", &rc_columns::mean_gap, &rc_result::mean_gap},
                          {"energy", &rc_columns::energy, &rc_result::energy},
                          {"stiffness", &rc_columns::stiffness, &rc_result::stiffness},
                          {"load_lower", &rc_columns::load_lower, &rc_result::load_lower},
                          {"load_upper", &rc_columns::load_upper, &rc_result::load_upper},
                          {"area_lower", &rc_columns::area_lower, &rc_result::area_lower},
                          {"area_upper", &rc_columns::area_upper, &rc_result::area_upper},
                          {"stiffness_lower", &rc_columns::stiffness_lower, &rc_result::stiffness_lower},
                          {"stiffness_upper", &rc_columns::stiffness_upper, &rc_result::stiffness_upper}};

constexpr double shares[] = {0.3, 0.7, 1};

Field targets_of(const Problem& problem) {
  Field targets;
  for (const double share : shares) targets.push_back(share * problem.target);
  return targets;
}

rc_history history_of(const Problem& problem, const Field& targets) {
  rc_history history = RC_HISTORY_INIT;
  history.control = problem.control;
  history.n = static_cast<std::int64_t>(targets.size());
  history.targets = RC_IN(targets.data());
  history.undeformed_gap = RC_IN(problem.gap.data());
  return history;
}

rc_batch batch_of(const Problem& problem, const Field& targets, std::int64_t n) {
  rc_batch batch = RC_BATCH_INIT;
  batch.control = problem.control;
  batch.n = n;
  batch.steps = static_cast<std::int64_t>(targets.size());
  batch.targets = RC_IN(targets.data());
  batch.undeformed_gap = RC_IN(problem.gap.data());
  batch.target_stride = batch.undeformed_gap_stride = RC_BATCH_SHARED;
  return batch;
}

// The answers of single steps with these options.
std::vector<rc_result> results_of(const Problem& problem, const Field& targets, const Pair& pair) {
  const Contact contact(problem, pair, {{RC_OPT_STIFFNESS, "2"}});
  std::vector<rc_result> results;
  for (const double target : targets) {
    rc_step step = problem.step();
    step.target = target;
    const Answer answer = contact.solve(step);
    check_status(answer, RC_OK);
    results.push_back(answer.result);
  }
  return results;
}

void check_output(const Output& output, const Field& found, const std::vector<rc_result>& expected) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double value = expected[i % expected.size()].*output.of_result;
    check(std::isfinite(value), std::string(output.name) + " is not known");
    check_near(found[i], value, 1e-12 * std::abs(value), output.name);
  }
}

// Each output by itself asks for what it needs, and for no more.
void each_output_comes_by_itself() {
  const Problem problem = rough_problem(18, 14, RC_BOUNDARY_FREE, 0.5, 0.75);
  const Field targets = targets_of(problem);
  const std::vector<rc_result> expected = results_of(problem, targets, automatic);
  for (const Output& output : outputs) {
    Field found(targets.size()), of_batch(2 * targets.size());
    rc_history history = history_of(problem, targets);
    rc_batch batch = batch_of(problem, targets, 2);
    history.columns.*output.column = RC_OUT(found.data());
    batch.columns.*output.column = RC_OUT(of_batch.data());
    check(rc_contact_solve_history(Contact(problem, automatic, {{RC_OPT_BOUNDS, "0"}}).handle(), &history) == RC_OK,
          rc_last_error());
    check_output(output, found, expected);
    check(rc_batch_solve(&problem.system, make_options(automatic, problem.kernel).get(), &batch) == RC_OK, rc_last_error());
    check_output(output, of_batch, expected);
  }
}

// A batch writes NaN to all of them for steps without an answer.
void a_step_without_an_answer_has_no_numbers() {
  const Problem problem = rough_problem(18, 14, RC_BOUNDARY_FREE, 0.5, 0.75);
  const Field targets = {0.3 * problem.target, std::numeric_limits<double>::quiet_NaN()};
  rc_batch batch = batch_of(problem, targets, 1);
  Field found[std::size(outputs)];
  for (std::size_t k = 0; k < std::size(outputs); ++k) {
    found[k].assign(2, -7);
    batch.columns.*outputs[k].column = RC_OUT(found[k].data());
  }
  check_equal(rc_batch_solve(&problem.system, nullptr, &batch), RC_ERR_ARGUMENT, "status");
  for (std::size_t k = 0; k < std::size(outputs); ++k)
    check(std::isfinite(found[k][0]) && std::isnan(found[k][1]), outputs[k].name);
}

// The gap stays hidden from fn where it is not wanted, and the points are those of the step that fn sees.
struct Watched {
  const Contact& contact;
  std::size_t points = 0;
  std::string wrong = {};
};

std::int32_t watch_points(std::int64_t step, const rc_result* result, void* user) {
  Watched& watched = *static_cast<Watched*>(user);
  const auto* const p = static_cast<const double*>(result->p.data);
  std::vector<std::int64_t> index(static_cast<std::size_t>(result->contacts));
  Field pressure(index.size());
  std::int64_t n = -1;
  if (rc_contact_points(watched.contact.handle(), result->contacts, RC_OUT(index.data()), RC_OUT(pressure.data()), &n) != RC_OK)
    watched.wrong = rc_last_error();
  if (result->gap.data) watched.wrong = "the gap is shown";
  if (n != result->contacts) watched.wrong = "points of another step, at step " + std::to_string(step);
  std::size_t k = 0;
  for (std::size_t i = 0; i < watched.points && watched.wrong.empty(); ++i) {
    if (!(p[i] > 0)) continue;
    if (index[k] != static_cast<std::int64_t>(i) || pressure[k] != p[i]) watched.wrong = "another point " + std::to_string(i);
    ++k;
  }
  return 0;
}

void fn_may_ask_for_its_points(const Settings& settings) {
  const Problem problem = rough_problem(72, 60, RC_BOUNDARY_PERIODIC);
  const Field targets = targets_of(problem);
  const Contact contact(problem, automatic, settings);
  Field mean_gap(targets.size());
  rc_history history = history_of(problem, targets);
  Watched watched{contact, problem.points()};
  history.fn = watch_points;
  history.user = &watched;
  history.want_gap = 0;
  history.columns.mean_gap = RC_OUT(mean_gap.data());
  check(rc_contact_solve_history(contact.handle(), &history) >= 0, rc_last_error());
  check_equal(history.completed, history.n, "completed steps");
  check(watched.wrong.empty(), watched.wrong);
  for (const double value : mean_gap) check(value > 0, "mean gap");
}

// With periodic boundaries the approach is the change of the mean gap; a free body deflects below its contact.
void a_periodic_approach_is_the_change_of_the_mean_gap() {
  for (const std::int32_t boundary : {RC_BOUNDARY_PERIODIC, RC_BOUNDARY_FREE})
    for (const std::int32_t control : controls) {
      Problem problem = rough_problem(40, 36, boundary, 0.5, 0.75);
      const double mean = sum(problem.gap) / static_cast<double>(problem.points());
      if (control == RC_CONTROL_LOAD) problem = at_load(problem, solved(problem, automatic).result.load);
      const Field targets = targets_of(problem);
      Field mean_gap(targets.size()), approach(targets.size());
      rc_history history = history_of(problem, targets);
      history.columns.mean_gap = RC_OUT(mean_gap.data());
      history.columns.approach = RC_OUT(approach.data());
      check(rc_contact_solve_history(Contact(problem, automatic).handle(), &history) == RC_OK, rc_last_error());
      for (std::size_t i = 0; i < targets.size(); ++i) {
        const double off = std::abs(mean - mean_gap[i] - approach[i]);
        check(boundary == RC_BOUNDARY_PERIODIC ? off <= 1e-6 * approach[i] : off > 1e-3 * approach[i],
              "the change of the mean gap is off by " + text(off) + " at approach " + text(approach[i]));
      }
    }
}

}  // namespace

std::vector<Test> output_tests() {
  std::vector<Test> tests;
  tests.push_back({"each_output_comes_by_itself", each_output_comes_by_itself});
  tests.push_back({"a_step_without_an_answer_has_no_numbers", a_step_without_an_answer_has_no_numbers});
  tests.push_back({"fn_may_ask_for_its_points", [] { fn_may_ask_for_its_points({}); }});
  tests.push_back({"fn_may_ask_for_its_points_within_goal", [] { fn_may_ask_for_its_points({{RC_OPT_ACCURACY, "0.05"}}); }});
  tests.push_back({"a_periodic_approach_is_the_change_of_the_mean_gap", a_periodic_approach_is_the_change_of_the_mean_gap});
  return tests;
}

}  // namespace paths
