// Leaks of contacts on larger grids: where they close, how narrow their intervals are, and where there is none. That intervals
// hold the exact flow, also of wrong pressures and at a load, is a property of scenes.
#include <cmath>

#include "flows.h"
#include "support/cmocka.hpp"
#include "support/surfaces.h"

using namespace flow_tests;

namespace {

using pairs::Answer, pairs::Problem;

Problem periodic_scene(std::int64_t n) { return pairs::rough_problem(n, n, RC_BOUNDARY_PERIODIC); }

// At a mean pressure.
Answer pressed(const Problem& scene, double pressure, const char* tol) {
  const double load = pressure * static_cast<double>(scene.points());
  return pairs::solved(pairs::at_load(scene, load), pairs::automatic, {{RC_OPT_TOL, tol}});
}

rc_flow_result leak(const Problem& scene, Answer answer, std::int32_t along) {
  rc_flow_spec spec = RC_FLOW_SPEC_INIT;
  spec.along = along;
  spec.viscosity = 1.0 / 12;
  spec.pressure_drop = 1;
  spec.width = 1e-6;
  answer.result.p = RC_OUT(answer.p.data());
  answer.result.gap = RC_OUT(answer.gap.data());
  rc_flow_result found = RC_FLOW_RESULT_INIT;
  if (RC_FAILED(rc_flow_of_result(&scene.system, nullptr, &answer.result, &spec, &found))) fail_msg("%s", rc_flow_last_error());
  return found;
}

rc_flow_closing closing(const Problem& scene, std::int32_t along, double width) {
  rc_flow_spec spec = RC_FLOW_SPEC_INIT;
  spec.along = along;
  spec.width = width;
  const rc_step step = scene.step();
  rc_flow_closing found = RC_FLOW_CLOSING_INIT;
  if (RC_FAILED(rc_flow_closing_pressure(&scene.system, nullptr, &step, &spec, &found))) fail_msg("%s", rc_flow_last_error());
  return found;
}

void a_seal_is_open_below_its_closing_pressure_and_closed_above(void**) {
  for (const double hardness : {0.0, 0.05}) {
    Problem scene = periodic_scene(64);
    scene.system.hardness = hardness;
    for (const std::int32_t along : {RC_FLOW_X, RC_FLOW_Y}) {
      const rc_flow_closing found = closing(scene, along, 0.01);
      assert_int_equal(found.status, RC_OK);
      assert_true(found.lower > 0 && found.upper - found.lower <= 0.01 * found.upper);
      assert_true(leak(scene, pressed(scene, found.lower * 0.999, "1e-10"), along).lower > 0);
      assert_true(leak(scene, pressed(scene, found.upper * 1.001, "1e-10"), along).upper == 0);
      assert_true(found.area_fraction > 0.2 && found.constriction > 0 && found.steps > 3);
    }
  }
}

void a_wall_of_excluded_points_is_closed_without_a_load(void**) {
  Problem scene = periodic_scene(48);
  scene.mask.assign(scene.points(), 1);
  for (std::size_t y = 0; y < 48; ++y) scene.mask[y * 48 + 20] = 0;
  const rc_flow_closing found = closing(scene, RC_FLOW_X, 0.01);
  assert_true(found.status == RC_OK && found.lower == 0 && found.upper == 0);
}

// The interval's width over the flow at tol 1e-8, at the returned approach, well open and 1 % of the load short of closing.
void intervals_at_tol_1e_8_are_narrow(void**) {
  const Problem scene = periodic_scene(96);
  const double closes = closing(scene, RC_FLOW_X, 2e-3).lower;
  const rc_flow_result wide_open = leak(scene, pressed(scene, 0.2 * closes, "1e-8"), RC_FLOW_X);
  const rc_flow_result near = leak(scene, pressed(scene, 0.99 * closes, "1e-8"), RC_FLOW_X);
  print_message("widths %.1e and, near closing, %.1e\n", 1 - wide_open.lower / wide_open.upper, 1 - near.lower / near.upper);
  assert_true(wide_open.upper - wide_open.lower <= 1e-3 * wide_open.upper);
  assert_true(near.upper - near.lower <= 1e-2 * near.upper);
}

void full_contact_has_no_interval(void**) {
  const Problem scene = periodic_scene(48);
  const Answer full = pressed(scene, 2, "1e-8");
  if (!std::isnan(full.result.gap_error)) fail_msg("a gap is proven");
  const rc_flow_result found = leak(scene, full, RC_FLOW_X);
  assert_true(found.lower == 0 && std::isinf(found.upper) && found.status == RC_STOP_STALLED && found.flow == 0);
  Answer blind = pressed(scene, 0.01, "1e-8");
  blind.result.gap_error = NAN;  // as with option bounds 0
  const rc_flow_result unknown = leak(scene, blind, RC_FLOW_X);
  assert_true(unknown.lower == 0 && std::isinf(unknown.upper) && unknown.status == RC_STOP_STALLED && unknown.flow > 0);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_seal_is_open_below_its_closing_pressure_and_closed_above),
      cmocka_unit_test(a_wall_of_excluded_points_is_closed_without_a_load),
      cmocka_unit_test(intervals_at_tol_1e_8_are_narrow),
      cmocka_unit_test(full_contact_has_no_interval),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
