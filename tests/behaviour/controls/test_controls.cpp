// A contact pressed to a contact area or a mean pressure. That histories and batches have the bits of steps is a property of
// scenes.
#include <roughcontact/derivatives.h>
#include <roughcontact/history.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "behaviour/batch/study.h"
#include "behaviour/paths/history.h"
#include "support/naive.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace controls {

namespace {

using namespace pairs;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const Settings settings = {{RC_OPT_TOL, "1e-9"}};
const std::int32_t boundaries[] = {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC, RC_BOUNDARY_PERIODIC_X, RC_BOUNDARY_PERIODIC_Y};

double whole(const Problem& problem) { return static_cast<double>(problem.points()) * problem.cell_area(); }

Problem at_area(Problem problem, double share) {
  problem.control = RC_CONTROL_AREA;
  problem.target = share * whole(problem);
  return problem;
}

// Within 1e-3 of the area, or half a cell.
void check_met(double area, double target, const Problem& problem) {
  check_near(area, target, std::max(1e-3 * target, 0.5001 * problem.cell_area()), "area");
}

Problem rough(std::int32_t boundary) { return rough_problem(32, 28, boundary, 0.5, 0.75); }

// The area is met, and a step at the load found is the same contact.
void an_area_is_met(std::int32_t boundary) {
  const Problem problem = rough(boundary);
  for (const double share : {0.02, 0.1, 0.35, 0.8}) {
    const Answer found = solved(at_area(problem, share), automatic, settings);
    check_met(found.result.contact_area, share * whole(problem), problem);
    const Answer again = solved(at_load(problem, found.result.load), automatic, settings);
    check_equal(again.result.contacts, found.result.contacts, "points in contact at the load found");
    check_near(found.p, again.p, 1e-6, "p");
    check_near(sum(found.p) * problem.cell_area(), found.result.load, 1e-12 * found.result.load, "load of the pressures");
    check_equal(std::ranges::count_if(found.p, [](double p) { return p > 0; }), found.result.contacts, "points with pressure");
  }
}

void a_mean_pressure_is_a_load(std::int32_t boundary) {
  Problem problem = rough(boundary);
  const double load = 0.5 * solved(problem, automatic, settings).result.load;
  const Answer by_load = solved(at_load(problem, load), automatic, settings);
  problem.control = RC_CONTROL_PRESSURE;
  problem.target = load / whole(problem);
  const Answer found = solved(problem, automatic, settings);
  check_near(found.result.mean_pressure, problem.target, 1e-12 * problem.target, "mean pressure");
  check_near(found.p, by_load.p, 1e-9, "p");
  const Answer judged = Contact(problem, automatic, settings).certify(problem.step(), found.p);
  check_status(judged, RC_OK, "certified at the mean pressure");
}

// A solver that only knows approaches meets a load within the tolerance; its pressures then still fit the approach, to round-off.
void the_approach_fits_the_pressures(std::int32_t boundary) {
  double largest_miss = 0;
  for (const double share : {0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9}) {
    const Problem problem = rough(boundary);
    const Problem by_load = at_load(problem, share * solved(problem, automatic, settings).result.load);
    const Answer found = solved(by_load, {"nnls", "dense"}, {{RC_OPT_TOL, "0.1"}});
    check_near(found.result.kkt_dual, 0, 1e-10, "overlap of the pressures' own approach");
    check_near(found.result.kkt_complementarity, 0, 1e-10, "gap below the pressures");
    largest_miss = std::max(largest_miss, found.result.kkt_control);
  }
  check(largest_miss > 1e-6, "each load is met to round-off: nothing is tested");
}

void cold_steps_do_not_depend_on_earlier_ones() {
  const Problem problem = rough(RC_BOUNDARY_PERIODIC);
  const Contact contact(problem, automatic, settings);
  rc_step step = problem.step();
  step.control = RC_CONTROL_AREA;
  step.target = 0.2 * whole(problem);
  step.warm_start = 0;
  const Answer first = contact.solve(step);
  check_status(contact.solve(at_area(problem, 0.6)), RC_OK);
  const Answer again = contact.solve(step);  // operators may remember more: equal to round-off
  check_near(again.result.load, first.result.load, 1e-12 * first.result.load, "load");
  check_near(again.p, first.p, 1e-12, "p");
}

// Loads that were tried leave no indentation: a history at the loads found leaves the same.
void a_body_that_yields_keeps_no_trace_of_other_loads(std::int32_t boundary) {
  Problem problem = rough(boundary);
  problem.system.hardness = 0.4 * largest(solved(at_area(problem, 0.2), automatic, settings).p);
  const auto indentation = [&](const Contact& contact) {
    Field depth(problem.points());
    check(rc_contact_indentation(contact.handle(), RC_OUT(depth.data())) == RC_OK, rc_last_error());
    return depth;
  };
  paths::Request request;
  request.control = RC_CONTROL_AREA;
  request.targets = {0.1 * whole(problem), 0.3 * whole(problem), 0.2 * whole(problem)};
  const Contact contact(problem, automatic, settings), other(problem, automatic, settings);
  const paths::History found = paths::followed(contact, problem, request);
  for (std::size_t i = 0; i < request.targets.size(); ++i) check_met(found.contact_area[i], request.targets[i], problem);
  check(found.seen[1].result.capped > 0, "points at the hardness");
  request.control = RC_CONTROL_LOAD;
  request.targets = found.load;
  const paths::History again = paths::followed(other, problem, request);
  check_near(found.contact_area, again.contact_area, 1.01 * problem.cell_area() / found.contact_area[1], "areas at these loads");
  check_near(indentation(contact), indentation(other), 1e-5, "indentation");
  // A search that fails leaves none.
  const Field before = indentation(contact);
  const Contact stopped(problem, automatic, {settings[0], {RC_OPT_MAX_ITER, "3"}});
  check_status(stopped.solve(at_area(problem, 0.3)), RC_STOP_MAX_ITER);
  check(largest(indentation(stopped)) == 0, "no indentation after a stop");
  check(largest(before) > 0, "the history's indentation");
}

void the_nearest_area_is_in_the_note() {
  Problem problem = rough_problem(32, 8, RC_BOUNDARY_PERIODIC);
  for (std::size_t i = 0; i < problem.gap.size(); ++i)
    problem.gap[i] = 1e-2 * (1 - std::cos(2 * std::numbers::pi * static_cast<double>(i % 32) / 32));
  const Answer found = solved(at_area(problem, 0.2), automatic, settings);
  check(found.result.area_fraction == 7.0 / 32, "whole columns: " + text(found.result.area_fraction));
  check(std::string(found.result.note).find("area: 20 % asked, 21.9 % of the grid is the nearest") == 0, found.result.note);
  check(solved(at_area(problem, 1), automatic, settings).result.area_fraction == 1, "all touches");
}

// An area that the mask rules out: all points that may touch do.
void an_area_that_no_load_reaches() {
  Problem problem = rough(RC_BOUNDARY_PERIODIC);
  problem.mask.assign(problem.points(), 1);
  for (std::size_t i = 0; i < problem.points(); i += 4) problem.mask[i] = 0;
  const Answer found = solved(at_area(problem, 0.9), automatic, settings);
  check_near(found.result.area_fraction, 0.75, 1e-12, "area");
  check(std::string(found.result.note).find("75 % of the grid is the nearest") != std::string::npos, found.result.note);
  problem.mask.assign(problem.points(), 0);
  check_equal(solved(at_area(problem, 0.9), automatic, settings).result.contacts, 0, "nothing may touch");
  Problem hard = rough(RC_BOUNDARY_FREE);
  hard.system.hardness = 1e-2;
  check_near(solved(at_area(hard, 1), automatic, settings).result.area_fraction, 1, 1e-3, "all at the hardness");
}

void bad_targets_are_refused_and_change_nothing() {
  Problem problem = rough(RC_BOUNDARY_FREE);
  const Contact contact(problem, automatic, settings);
  const Answer before = contact.solve(at_area(problem, 0.1));
  const auto refused = [&](std::int32_t control, double target, rc_status status, const char* says) {
    rc_step step = problem.step();
    step.control = control;
    step.target = target;
    step.undeformed_gap.data = nullptr;
    const Answer answer = contact.solve(step);
    check_status(answer, status);
    check(answer.message.find(says) != std::string::npos, answer.message);
    check(answer.p[0] == -7 && answer.gap[0] == -7, "arrays of a refused step");
    paths::Request request;
    request.control = control;
    request.targets = {target};
    check_status({.status = paths::follow(contact, problem, request).status}, status, "history");
    batch::Study study = batch::rough_study(2, 1, control);
    study.targets.assign(2, target);
    check_status({.status = study.solve(1).status}, status, "batch");
  };
  refused(RC_CONTROL_AREA, -1e-3, RC_ERR_INFEASIBLE, "negative");
  refused(RC_CONTROL_AREA, 1e6 * whole(problem), RC_ERR_INFEASIBLE, "more than the area of the grid");
  refused(RC_CONTROL_PRESSURE, -1, RC_ERR_INFEASIBLE, "mean pressure = -1 is negative");
  refused(3, 1, RC_ERR_ARGUMENT, "= 3 is none of RC_CONTROL_APPROACH (1)");
  for (const std::int32_t control : {RC_CONTROL_AREA, RC_CONTROL_PRESSURE})
    for (const double bad : {nan, HUGE_VAL}) {
      rc_step step = problem.step();
      step.control = control;
      step.target = bad;
      check_status(contact.solve(step), RC_ERR_ARGUMENT);
    }
  rc_step by_area = problem.step();
  by_area.control = RC_CONTROL_AREA;
  check_status(contact.certify(by_area, before.p), RC_ERR_ARGUMENT, "certified at an area");
  rc_step zero = problem.step();
  for (const std::int32_t control : {RC_CONTROL_AREA, RC_CONTROL_PRESSURE}) {
    zero.control = control;
    const Answer none = (zero.target = 0, Contact(problem, automatic, settings).solve(zero));
    check_status(none, RC_OK);
    check(none.result.load == 0 && none.result.contacts == 0, "target 0 is load 0");
  }
}

std::int32_t multiply(const double* x, double* y, std::int64_t n, void* user) {
  struct Matrix {
    Field values;
    int products_left;
  };
  Matrix& matrix = *static_cast<Matrix*>(user);
  if (matrix.products_left-- == 0) return 1;
  const Field result = product(matrix.values, Field(x, x + n));
  std::copy(result.begin(), result.end(), y);
  return 0;
}

// Without a modulus the search begins at a quantile of the gaps.
void a_matrix_and_a_product_have_areas() {
  const Problem free = rough_problem(12, 10);
  const Field matrix = influence_matrix(free);
  for (const std::int32_t op : {RC_OPERATOR_DENSE, RC_OPERATOR_CALLBACK}) {
    struct {
      Field values;
      int products_left = -1;
    } of{matrix};
    Problem problem = free;
    problem.system = rc_system{RC_SYSTEM_INIT};
    problem.system.op = op;
    problem.system.nx = 12, problem.system.ny = 10, problem.system.hx = problem.system.hy = 1;
    problem.system.dense = op == RC_OPERATOR_DENSE ? matrix.data() : nullptr;
    problem.system.dense_ld = op == RC_OPERATOR_DENSE ? 120 : 0;
    problem.system.apply = op == RC_OPERATOR_CALLBACK ? multiply : nullptr;
    problem.system.user = op == RC_OPERATOR_CALLBACK ? &of : nullptr;
    for (const double share : {0.05, 0.3}) {
      const Answer found = solved(at_area(problem, share), automatic, settings);
      check_met(found.result.contact_area, share * whole(problem), problem);
    }
    problem.gap.assign(problem.points(), 2);
    check_near(solved(at_area(problem, 1), automatic, settings).result.area_fraction, 1, 1e-12, "a flat touches everywhere");
    if (op != RC_OPERATOR_CALLBACK) continue;
    problem.gap = free.gap;
    const Contact contact(problem, automatic, settings);
    of.products_left = 40;  // in a later load than the first
    const Answer failed = contact.solve(at_area(problem, 0.3));
    check_status(failed, RC_ERR_EXTERNAL);
    check(failed.p[0] == -7 && failed.gap[0] == -7, "arrays of a failed search");
  }
}

// A step after the search starts from its answer; derivatives are those at the load found.
void the_load_found_is_the_last_step() {
  const Problem problem = rough(RC_BOUNDARY_FREE);
  const Contact contact(problem, automatic, settings), other(problem, automatic, settings);
  const Answer found = contact.solve(at_area(problem, 0.15));
  check_status(other.solve(at_load(problem, found.result.load)), RC_OK);
  const auto gradient = [](const Contact& of) {
    rc_gradient g = RC_GRADIENT_INIT;
    check(rc_contact_gradient(of.handle(), &g) == RC_OK, rc_last_error());
    return g;
  };
  check_near(gradient(contact).dJ_dtarget, gradient(other).dJ_dtarget, 1e-6 * std::abs(gradient(other).dJ_dtarget), "dd/dW");
  std::int64_t n = 0;
  check(rc_contact_points(contact.handle(), 0, {}, {}, &n) == RC_OK && n == found.result.contacts, "points");
  // A search that is stopped keeps the last certified step.
  const Contact few(problem, automatic, {settings[0], {RC_OPT_MAX_ITER, "30"}});
  check_status(few.solve(at_load(problem, 1e-3 * found.result.load)), RC_OK);
  std::int64_t kept = 0, after = 0;
  rc_contact_points(few.handle(), 0, {}, {}, &kept);
  check_status(few.solve(at_area(problem, 0.4)), RC_STOP_MAX_ITER, "iterations of all loads count");
  rc_contact_points(few.handle(), 0, {}, {}, &after);
  check_equal(after, kept, "points of the last certified step");
}

void pressures_may_be_single() {
  const Problem problem = rough(RC_BOUNDARY_PERIODIC);
  const Contact contact(problem, automatic, settings);
  rc_step step = problem.step();
  step.control = RC_CONTROL_AREA;
  step.target = 0.1 * whole(problem);
  std::vector<float> p(problem.points());
  rc_result result = RC_RESULT_INIT;
  result.p.data = p.data();
  result.p.type = RC_SINGLE;
  check(rc_contact_solve(contact.handle(), &step, &result) == RC_OK, rc_last_error());
  check_equal(std::ranges::count_if(p, [](float each) { return each > 0; }), result.contacts, "points");
}

std::vector<Test> tests() {
  std::vector<Test> all = {{"cold_steps_do_not_depend_on_earlier_ones", cold_steps_do_not_depend_on_earlier_ones},
                           {"the_nearest_area_is_in_the_note", the_nearest_area_is_in_the_note},
                           {"an_area_that_no_load_reaches", an_area_that_no_load_reaches},
                           {"bad_targets_are_refused_and_change_nothing", bad_targets_are_refused_and_change_nothing},
                           {"a_matrix_and_a_product_have_areas", a_matrix_and_a_product_have_areas},
                           {"the_load_found_is_the_last_step", the_load_found_is_the_last_step},
                           {"pressures_may_be_single", pressures_may_be_single}};
  for (const std::int32_t boundary : boundaries) {
    const std::string name = "/" + std::to_string(boundary);
    const auto add = [&](const char* test, const auto& body) {
      all.push_back({test + name, [boundary, body] { body(boundary); }});
    };
    add("an_area_is_met", an_area_is_met);
    add("a_mean_pressure_is_a_load", a_mean_pressure_is_a_load);
    add("the_approach_fits_the_pressures", the_approach_fits_the_pressures);
    add("a_body_that_yields_keeps_no_trace_of_other_loads", a_body_that_yields_keeps_no_trace_of_other_loads);
  }
  return all;
}

}  // namespace

}  // namespace controls

int main(int argc, char** argv) { return pairs::run_group("controls", controls::tests(), argc, argv); }
