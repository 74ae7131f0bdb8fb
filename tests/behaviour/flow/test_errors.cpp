// Bad input, stops, and memory that runs out at every allocation.
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "allocators.h"
#include "flows.h"
#include "support/cmocka.hpp"
#include "support/failing_new.h"
#include "support/surfaces.h"

using namespace flow_tests;

namespace {

Field rough(std::int64_t n) {
  std::mt19937 random(8);
  Field field = uniform(n, n, 0);
  for (double& g : field.g) g = random() % 5 == 0 ? 0 : static_cast<double>(random()) * 0x1p-32;
  return field;
}

template <class Change> void refuses(rc_status expected, const char* text, const Change& change) {
  Field field = rough(6);
  field.error.assign(field.g.size(), 0.01);
  rc_flow_spec spec = spec_of(field);
  change(spec, field);
  rc_flow_result result = RC_FLOW_RESULT_INIT;
  result.flow = -7;
  const rc_status status = rc_flow_solve(&spec, &result);
  if (status != expected || !std::strstr(rc_flow_last_error(), text))
    fail_msg("status %d, \"%s\"; expected %d and \"%s\"", status, rc_flow_last_error(), expected, text);
  assert_true(result.flow == -7);
}

void wrong_input_is_refused_by_name(void**) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  refuses(RC_ERR_ARGUMENT, "viscosity = 0", [](rc_flow_spec& spec, Field&) { spec.viscosity = 0; });
  refuses(RC_ERR_ARGUMENT, "pressure_drop = nan", [&](rc_flow_spec& spec, Field&) { spec.pressure_drop = nan; });
  refuses(RC_ERR_ARGUMENT, "width = 0", [](rc_flow_spec& spec, Field&) { spec.width = 0; });
  refuses(RC_ERR_ARGUMENT, "memory = -1", [](rc_flow_spec& spec, Field&) { spec.memory = -1; });
  refuses(RC_ERR_ARGUMENT, "along = 3", [](rc_flow_spec& spec, Field&) { spec.along = 3; });
  refuses(RC_ERR_ARGUMENT, "sides = 0", [](rc_flow_spec& spec, Field&) { spec.sides = 0; });
  refuses(RC_ERR_ARGUMENT, "hx = 0", [](rc_flow_spec& spec, Field&) { spec.hx = 0; });
  refuses(RC_ERR_SHAPE, "nx = 0", [](rc_flow_spec& spec, Field&) { spec.nx = 0; });
  refuses(RC_ERR_SHAPE, "2^31 - 1", [](rc_flow_spec& spec, Field&) { spec.nx = spec.ny = 1 << 16; });
  refuses(RC_ERR_ARGUMENT, "gap is null", [](rc_flow_spec& spec, Field&) { spec.gap.data = nullptr; });
  refuses(RC_ERR_ARGUMENT, "gap.type = 1", [](rc_flow_spec& spec, Field&) { spec.gap.type = RC_SINGLE; });
  refuses(RC_ERR_ARGUMENT, "gap.memory = \"cuda\"", [](rc_flow_spec& spec, Field&) { spec.gap.memory = "cuda"; });
  refuses(RC_ERR_ARGUMENT, "gap has 1 values that are negative, infinite or NaN, the first at 7: -",
          [](rc_flow_spec&, Field& field) { field.g[7] = -0.5; });
  refuses(RC_ERR_ARGUMENT, "the first at 0: nan", [&](rc_flow_spec&, Field& field) { field.g[0] = field.g[3] = nan; });
  refuses(RC_ERR_ARGUMENT, "gap_error has 1", [&](rc_flow_spec&, Field& field) { field.error[35] = infinity; });
  refuses(RC_ERR_ARGUMENT, "choose another unit", [](rc_flow_spec&, Field& field) { field.g[1] = 1e200; });
}

struct Pressed {
  pairs::Problem problem = pairs::rough_problem(16, 16, RC_BOUNDARY_PERIODIC);
  pairs::Answer answer = pairs::solved(problem, pairs::automatic);
  rc_system system = problem.system;
  std::vector<double>&gap = problem.gap, &deformed = answer.gap;
  rc_step step = problem.step();
  rc_result result = answer.result;

  Pressed() {
    result.p.data = answer.p.data();
    result.gap.data = deformed.data();
  }
  Pressed(const Pressed&) = delete;
  Pressed& operator=(const Pressed&) = delete;
};

void wrong_results_are_refused_by_name(void**) {
  Pressed pressed;
  rc_flow_spec spec = RC_FLOW_SPEC_INIT;
  spec.viscosity = spec.pressure_drop = 1;
  rc_flow_result found = RC_FLOW_RESULT_INIT;
  const auto expect = [&](rc_status expected, const char* text) {
    const rc_status status = rc_flow_of_result(&pressed.system, nullptr, &pressed.result, &spec, &found);
    if (status != expected || !std::strstr(rc_flow_last_error(), text)) fail_msg("%d, \"%s\"", status, rc_flow_last_error());
  };
  pressed.result.gap.data = nullptr;
  expect(RC_ERR_ARGUMENT, "must be arrays that the step has written");
  pressed.result.gap.data = pressed.deformed.data();
  pressed.system.hardness = 1;
  spec.load = 1;
  expect(RC_ERR_INCOMPATIBLE, "with a hardness");
  spec.load = 0;
  pressed.system.op = RC_OPERATOR_CALLBACK;
  expect(RC_ERR_INCOMPATIBLE, "RC_OPERATOR_HALFSPACE or RC_OPERATOR_DENSE");
  pressed.system.op = RC_OPERATOR_HALFSPACE;
  pressed.deformed[9] = NAN;
  expect(RC_ERR_ARGUMENT, "rc_result.gap is nan at 9");
  rc_flow_closing closing = RC_FLOW_CLOSING_INIT;
  pressed.step.undeformed_gap.data = nullptr;
  assert_int_equal(rc_flow_closing_pressure(&pressed.system, nullptr, &pressed.step, &spec, &closing), RC_ERR_ARGUMENT);
  // A free ball on a plane leaks around its edges at any pressure.
  for (std::size_t i = 0; i < 256; ++i)
    pressed.gap[i] = std::pow(static_cast<double>(i % 16) - 7.5, 2) + std::pow(static_cast<double>(i / 16) - 7.5, 2);
  pressed.step.undeformed_gap.data = pressed.gap.data();
  pressed.system.hardness = 1e-3;
  pressed.system.boundary = RC_BOUNDARY_FREE;
  const rc_status status = rc_flow_closing_pressure(&pressed.system, nullptr, &pressed.step, &spec, &closing);
  if (status != RC_ERR_INFEASIBLE || !std::strstr(rc_flow_last_error(), "almost the hardness"))
    fail_msg("%d, \"%s\"", status, rc_flow_last_error());
}

void a_flag_stops_the_thread_s_calls(void**) {
  std::int32_t flag = 1;
  rc_flow_stop_when(&flag);
  const Field field = rough(20);
  const rc_flow_spec spec = spec_of(field);
  rc_flow_result result = RC_FLOW_RESULT_INIT;
  assert_int_equal(rc_flow_solve(&spec, &result), RC_STOP_CANCELLED);
  flag = 0;
  Pressed pressed;
  rc_flow_closing closing = RC_FLOW_CLOSING_INIT;
  flag = 1;
  rc_flow_spec along = RC_FLOW_SPEC_INIT;
  assert_int_equal(rc_flow_closing_pressure(&pressed.system, nullptr, &pressed.step, &along, &closing), RC_STOP_CANCELLED);
  rc_flow_stop_when(nullptr);
  assert_true(RC_FAILED(rc_flow_solve(&spec, &result)) == 0);
}

// Calls again and again, each time with another allocation that fails.
template <class Call> void every_allocation_may_fail(const char* name, const Call& call) {
  for (const bool forever : {false, true})
    for (int k = 1;; ++k) {
      support::fail_allocation(k, forever);
      const rc_status status = call();
      const bool failed = support::allocation_failed();
      support::fail_allocation(0);
      if (failed && (status == RC_ERR_MEMORY || !RC_FAILED(status))) continue;
      if (failed || RC_FAILED(status)) fail_msg("%s, allocation %d: %d, %s", name, k, status, rc_flow_last_error());
      print_message("%s: %d allocations\n", name, k);
      break;
    }
}

void memory_that_runs_out_is_a_status(void**) {
  const Field field = rough(40);
  rc_flow_spec spec = spec_of(field), leak = RC_FLOW_SPEC_INIT;
  Pressed pressed;
  rc_flow_result result = RC_FLOW_RESULT_INIT;
  rc_flow_factors tensor = RC_FLOW_FACTORS_INIT;
  rc_flow_closing closing = RC_FLOW_CLOSING_INIT;
  every_allocation_may_fail("flow", [&] { return rc_flow_solve(&spec, &result); });
  every_allocation_may_fail("factors", [&] { return rc_flow_factors_find(&spec, &tensor); });
  spec.memory = 1;
  every_allocation_may_fail("flow by iterations", [&] { return rc_flow_solve(&spec, &result); });
  leak.viscosity = leak.pressure_drop = 1;
  every_allocation_may_fail("leak", [&] { return rc_flow_of_result(&pressed.system, nullptr, &pressed.result, &leak, &result); });
  leak.width = 0.5;
  every_allocation_may_fail("closing",
                            [&] { return rc_flow_closing_pressure(&pressed.system, nullptr, &pressed.step, &leak, &closing); });
}

}  // namespace

int main() {
  contract::let_dependencies_use_operator_new();
  const CMUnitTest tests[] = {
      cmocka_unit_test(wrong_input_is_refused_by_name),
      cmocka_unit_test(wrong_results_are_refused_by_name),
      cmocka_unit_test(a_flag_stops_the_thread_s_calls),
      cmocka_unit_test(memory_that_runs_out_is_a_status),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
