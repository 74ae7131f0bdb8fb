// Arrays of 4 bytes a point: a gap of floats is worth its values as doubles, and answers are rounded once.
#include <roughcontact/plugin.h>

#include <algorithm>

#include "invariance_tests.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

using Singles = std::vector<float>;

Singles rounded(const Field& values) { return {values.begin(), values.end()}; }
Field widened(const Singles& values) { return {values.begin(), values.end()}; }

void check_same_singles(const Singles& a, const Field& b, const char* what) { check_same(widened(a), widened(rounded(b)), what); }

// The gap of a problem in 4 bytes a point, and the same values as doubles.
struct InSingle {
  explicit InSingle(Problem given) : problem(std::move(given)), gap(rounded(problem.gap)) { problem.gap = widened(gap); }
  rc_step step(bool borrow) const {
    rc_step step = problem.step();
    step.undeformed_gap = {gap.data(), RC_SINGLE, 0, nullptr};
    step.borrow = borrow;
    return step;
  }

  Problem problem;
  Singles gap;
};

struct SingleAnswer {
  explicit SingleAnswer(std::size_t points) : p(points), gap(points) {
    result.p = {p.data(), RC_SINGLE, 0, nullptr};
    result.gap = {gap.data(), RC_SINGLE, 0, nullptr};
  }
  rc_result result = RC_RESULT_INIT;
  Singles p, gap;
};

void check_same_answer(const SingleAnswer& single, const Answer& answer) {
  check_same_singles(single.p, answer.p, "p");
  check_same_singles(single.gap, answer.gap, "gap");
  const auto numbers = [](const rc_result& r) {
    return Field{r.load, r.approach, r.energy, r.kkt_dual, r.load_lower, r.load_upper};
  };
  check_same(numbers(single.result), numbers(answer.result), "result");
  check_equal(single.result.products, answer.result.products, "products");
}

Problem at_points(std::int64_t nx, std::int64_t ny, std::int32_t boundary) {
  Problem problem = rough_problem(nx, ny, boundary, 0.5, 0.75);
  problem.target *= 1.4;
  return problem;
}

// Three steps of one contact, each as singles and as doubles: without array, copied, and borrowed.
void gap_is_worth_its_values(std::int32_t boundary, const Pair& pair) {
  Problem masked = at_points(33, 26, boundary);
  masked.mask.assign(masked.points(), 1);
  for (std::size_t i = 5; i < masked.points(); i += 7) masked.mask[i] = 0;
  for (const Problem& each : {at_points(33, 26, boundary), masked}) {
    const InSingle given(each);
    const Contact in_single(given.problem, pair), in_double(given.problem, pair);
    for (const bool borrow : {false, true}) {
      const rc_step step = given.step(borrow);
      SingleAnswer single(given.problem.points());
      const rc_status status = rc_contact_solve(in_single.handle(), &step, &single.result);
      const Answer answer = in_double.solve(given.problem);
      check_equal(status, answer.status, "status");
      check_same_answer(single, answer);
    }
    rc_step again = given.problem.step();
    again.undeformed_gap.data = nullptr;
    again.mask.data = nullptr;
    again.target *= 1.1;
    SingleAnswer single(given.problem.points());
    const rc_status status = rc_contact_solve(in_single.handle(), &again, &single.result);
    const Answer answer = in_double.solve(again);
    check_equal(status, answer.status, "status");
    check_same_answer(single, answer);
  }
}

// By load, with a hardness that the second step's surface is indented by.
void hardness_indents_it(std::int32_t boundary) {
  Problem problem = at_points(33, 26, boundary);
  const Answer elastic = solved(problem, automatic);
  problem = at_load(problem, elastic.result.load);
  problem.system.hardness = 0.5 * largest(elastic.p);
  const InSingle given(problem);
  const Contact in_single(given.problem, automatic), in_double(given.problem, automatic);
  for (const double share : {1.0, 0.5}) {
    rc_step step = given.step(true), wide = given.problem.step();
    step.target = wide.target = share * problem.target;
    SingleAnswer single(given.problem.points());
    const rc_status status = rc_contact_solve(in_single.handle(), &step, &single.result);
    const Answer answer = in_double.solve(wide);
    check_equal(status, answer.status, "status");
    check_same_answer(single, answer);
  }
}

void certified_from_singles() {
  const InSingle given(at_points(33, 26, RC_BOUNDARY_FREE));
  const Answer answer = solved(given.problem, automatic);
  const Contact contact(given.problem, automatic, {{"tol", "1e-6"}});
  SingleAnswer single(given.problem.points());
  std::copy(answer.p.begin(), answer.p.end(), single.p.begin());
  const rc_step step = given.step(false);
  const rc_status status = rc_contact_certify(contact.handle(), &step, &single.result);
  check(status == RC_OK, rc_last_error());
  const Answer wide = contact.certify(given.problem.step(), widened(rounded(answer.p)));
  check_same_answer(single, wide);
}

// Sparse contact, and a goal that a coarser grid meets.
void coarser_grids_serve_it(const Settings& settings, rc_status expected) {
  Problem problem = rough_problem(256, 256);
  problem.target = problem.lowest_gap() + 0.15 * (problem.target - problem.lowest_gap());
  const InSingle given(problem);
  const Contact in_single(given.problem, automatic, settings), in_double(given.problem, automatic, settings);
  SingleAnswer single(given.problem.points());
  const rc_step step = given.step(true);
  check_equal(rc_contact_solve(in_single.handle(), &step, &single.result), expected, "status");
  const Answer answer = in_double.solve(given.problem);
  check_equal(answer.status, expected, "status in double");
  check_same_answer(single, answer);
}

// A solver that asks for nothing new sees the gap in doubles, also where another one warms up for it.
Field seen;
rc_status look(const rc_host*, const rc_problem* problem, const rc_options*, double*, double*) {
  const rc_grid& grid = *problem->grid;
  if (grid.undeformed_gap.type != RC_NATIVE || !grid.undeformed_gap.data) return RC_STOP_STALLED;
  const auto* const gap = static_cast<const double*>(grid.undeformed_gap.data);
  seen.assign(gap, gap + grid.nx * grid.ny);
  return RC_STOP_STALLED;
}

void other_solvers_see_doubles() {
  const rc_solver solver = {.struct_size = sizeof(rc_solver),
                            .name = "looks",
                            .summary = "a test's",
                            .license = "BSD-3-Clause",
                            .needs = RC_NEEDS_GRID,
                            .controls = RC_CONTROL_APPROACH,
                            .solve = look};
  const rc_solver* const list[] = {&solver};
  const rc_plugin plugin = {.struct_size = sizeof(rc_plugin),
                            .abi_major = RC_PLUGIN_ABI_MAJOR,
                            .abi_minor = RC_PLUGIN_ABI_MINOR,
                            .name = "tests",
                            .version = "1",
                            .n_solvers = 1,
                            .solvers = list};
  const InSingle given(at_points(33, 26, RC_BOUNDARY_FREE));
  const rc_step step = given.step(true);
  for (const char* first : {"none", "haar-cg"}) {
    rc_context* made = nullptr;
    rc_status status = rc_context_create(0, nullptr, nullptr, nullptr, &made);
    check(status == RC_OK, rc_last_error());
    const Context context(made);
    status = rc_context_register(made, &plugin);
    check(status == RC_OK, rc_last_error());
    const Contact contact(given.problem, {"looks", "dense"}, {{"warmup", first}}, context.get());
    seen.clear();
    SingleAnswer single(given.problem.points());
    const rc_status expected = std::string(first) == "none" ? RC_STOP_STALLED : RC_OK;
    check_equal(rc_contact_solve(contact.handle(), &step, &single.result), expected, "status");
    check_same(seen, given.problem.gap, "what the solver saw");
  }
}

// Pressures as doubles beside a gap of floats.
void each_array_has_its_type() {
  const Problem problem = at_points(33, 26, RC_BOUNDARY_FREE);
  const Contact contact(problem, automatic);
  SingleAnswer single(problem.points());
  Field p(problem.points());
  single.result.p = {p.data(), RC_NATIVE, 0, nullptr};
  const rc_step step = problem.step();
  check_equal(rc_contact_solve(contact.handle(), &step, &single.result), RC_OK, "status");
  const Answer answer = contact.solve(problem);
  check_same(p, answer.p, "p");
  check_same_singles(single.gap, answer.gap, "gap");
  check(largest(p) > 0, "no contact");
}

// A start of floats is worth its values.
void started_from_singles() {
  const Problem problem = at_points(33, 26, RC_BOUNDARY_FREE);
  const Singles start = rounded(solved(problem, automatic).p);
  const Field wide = widened(start);
  rc_step step = problem.step(), wide_step = step;
  step.p0 = {start.data(), RC_SINGLE, 0, nullptr};
  wide_step.p0.data = wide.data();
  const Contact in_single(problem, automatic), in_double(problem, automatic);
  const Answer a = in_single.solve(step), b = in_double.solve(wide_step);
  check_equal(a.status, RC_OK, "status");
  check_same(a.p, b.p, "p");
  check_equal(a.result.iterations, b.result.iterations, "iterations");
}

}  // namespace

std::vector<Test> single_array_tests() {
  std::vector<Test> tests;
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    add_for_pairs(tests, "gap_of_floats_is_worth_its_values", boundary,
                  [=](const Pair& pair) { gap_is_worth_its_values(boundary, pair); });
    tests.push_back({"hardness_indents_a_gap_of_floats", [=] { hardness_indents_it(boundary); }});
  }
  tests.push_back({"pressures_of_floats_are_certified", certified_from_singles});
  tests.push_back({"sparse_contact_of_floats", [] { coarser_grids_serve_it({{"tol", "1e-8"}, {"backend", "split"}}, RC_OK); }});
  tests.push_back({"goal_on_a_coarser_grid_of_floats", [] { coarser_grids_serve_it({{"accuracy", "0.2"}}, RC_WITHIN_GOAL); }});
  tests.push_back({"other_solvers_see_doubles", other_solvers_see_doubles});
  tests.push_back({"each_array_has_its_type", each_array_has_its_type});
  tests.push_back({"starts_of_floats_are_worth_their_values", started_from_singles});
  return tests;
}

}  // namespace pairs
