// Intervals of contacts that are solved loosely, or whose pressures are perturbed, against the same contacts solved to round-off.
#include <roughcontact/surface.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "flows.h"
#include "support/cmocka.hpp"

using namespace flow_tests;

namespace {

struct Solution {
  rc_result result = RC_RESULT_INIT;
  std::vector<double> p, gap;
};

void require_usable(rc_status status, const char* what) {
  if (RC_FAILED(status)) fail_msg("%s: %s", what, rc_last_error());
}

struct Scene {
  rc_system system = RC_SYSTEM_INIT;
  std::vector<double> gap;
  std::vector<std::uint8_t> mask;  // empty: none

  std::size_t points() const { return gap.size(); }
  rc_step step(std::int32_t control, double target) const {
    rc_step step = RC_STEP_INIT;
    step.control = control;
    step.target = target;
    step.undeformed_gap.data = gap.data();
    if (!mask.empty()) step.mask.data = mask.data();
    return step;
  }
  // p: empty, or pressures that are certified instead of solved for.
  Solution solved(std::int32_t control, double target, double tol, const std::vector<double>& p = {}) const {
    rc_options* options = nullptr;
    rc_contact* contact = nullptr;
    require_usable(rc_options_create(nullptr, &options), "options");
    require_usable(rc_options_set_number(options, RC_OPT_TOL, tol), "tol");
    require_usable(rc_contact_create(&system, options, &contact), "contact");
    rc_options_destroy(options);
    Solution s;
    s.p = p.empty() ? std::vector<double>(points()) : p;
    s.gap.resize(points());
    s.result.p.data = s.p.data();
    s.result.gap.data = s.gap.data();
    const rc_step given = step(control, target);
    require_usable(p.empty() ? rc_contact_solve(contact, &given, &s.result) : rc_contact_certify(contact, &given, &s.result),
                   "step");
    rc_contact_destroy(contact);
    return s;
  }
  rc_flow_result leak(const Solution& s, std::int32_t along, double load = 0) const {
    rc_flow_spec spec = RC_FLOW_SPEC_INIT;
    spec.along = along;
    spec.viscosity = 1.0 / 12;
    spec.pressure_drop = 1;
    spec.width = 1e-6;
    spec.load = load;
    if (!mask.empty()) spec.mask.data = mask.data();
    rc_flow_result found = RC_FLOW_RESULT_INIT;
    if (RC_FAILED(rc_flow_of_result(&system, nullptr, &s.result, &spec, &found))) fail_msg("%s", rc_flow_last_error());
    return found;
  }
};

Scene random_scene(Random& random, std::uint64_t seed) {
  Scene scene;
  rc_system& system = scene.system;
  const std::int32_t boundaries[] = {RC_BOUNDARY_PERIODIC, RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC_X, RC_BOUNDARY_PERIODIC_Y};
  system.boundary = boundaries[random.below(4)];
  system.nx = 48 + 8 * random.below(7);
  system.ny = 48 + 8 * random.below(7);
  system.hx = system.hy = 1;
  system.modulus = 1;
  rc_surface_spectral_spec spec = RC_SURFACE_SPECTRAL_SPEC_INIT;
  spec.seed = seed;
  spec.nx = system.nx;
  spec.ny = system.ny;
  spec.rms_height = 0;
  spec.rms_slope = 0.1;
  spec.q_rolloff = 2 * 3.14159265358979 / 24;
  spec.q_high = 2 * 3.14159265358979 / 8;
  scene.gap.resize(static_cast<std::size_t>(system.nx * system.ny));
  if (rc_surface_spectral(&spec, scene.gap.data()) != RC_OK) fail_msg("%s", rc_surface_last_error());
  if (random.next() < 0.3) {
    scene.mask.assign(scene.points(), 1);
    const std::int64_t x0 = random.below(system.nx / 2), y0 = random.below(system.ny / 2);
    for (std::int64_t y = y0; y < y0 + 12; ++y)
      for (std::int64_t x = x0; x < x0 + 9; ++x) scene.mask[static_cast<std::size_t>(y * system.nx + x)] = 0;
  }
  if (random.next() < 0.3) system.hardness = 0.03 + 0.03 * random.next();
  require_usable(rc_gap_from_heights(system.nx * system.ny, RC_IN(scene.gap.data()),
                                     RC_IN(scene.mask.empty() ? nullptr : scene.mask.data()), RC_OUT(scene.gap.data())),
                 "gap");
  return scene;
}

bool quick() { return std::getenv("RC_TEST_QUICK") != nullptr; }

// Both intervals contain the exact flow, so they overlap; the reference's is narrow.
void require_overlap(const rc_flow_result& found, const rc_flow_result& exact, const char* what, int k) {
  if (!(found.lower <= exact.upper && exact.lower <= found.upper))
    fail_msg("scene %d, %s: %.17g .. %.17g, exact %.17g .. %.17g", k, what, found.lower, found.upper, exact.lower, exact.upper);
}

void no_exact_flow_lies_outside_of_a_loose_contacts_interval(void**) {
  Random random(77);
  const int scenes = quick() ? 24 : 500;
  int open = 0, closed = 0, loads = 0;
  for (int k = 0; k < scenes; ++k) {
    const Scene scene = random_scene(random, static_cast<std::uint64_t>(k) + 1);
    const double area = static_cast<double>(scene.points());
    const bool hard = scene.system.hardness > 0;
    const double pressure = (0.002 + 0.03 * random.next()) * (hard ? 0.5 : 1), load = pressure * area;
    const std::int32_t along = random.next() < 0.5 ? RC_FLOW_X : RC_FLOW_Y;
    const double tol = std::pow(10, -2 - 5 * random.next());
    const Solution loose = scene.solved(RC_CONTROL_LOAD, load, tol);
    // The exact contact at the approach that the loose one returned.
    const Solution exact = scene.solved(RC_CONTROL_APPROACH, loose.result.approach, 1e-12);
    const rc_flow_result reference = scene.leak(exact, along);
    const rc_flow_result found = scene.leak(loose, along);
    require_overlap(found, reference, "at the approach", k);
    assert_true(found.gap_error >= loose.result.gap_error);
    open += found.lower > 0;
    closed += found.upper == 0;
    std::vector<double> perturbed = exact.p;
    const double noise = std::pow(10, -1 - 5 * random.next());
    for (double& p : perturbed) {
      p = std::max(0.0, p * (1 + noise * (random.next() - 0.5)));
      if (hard) p = std::min(p, scene.system.hardness);
    }
    require_overlap(scene.leak(scene.solved(RC_CONTROL_APPROACH, loose.result.approach, 1e-12, perturbed), along), reference,
                    "perturbed", k);
    if (hard) continue;
    ++loads;
    const Solution at_load = scene.solved(RC_CONTROL_LOAD, load, 1e-12);
    require_overlap(scene.leak(loose, along, load), scene.leak(at_load, along), "at the load", k);
  }
  print_message("%d scenes, %d proven open, %d proven closed, %d loads\n", scenes, open, closed, loads);
  assert_true(open > scenes / 4 && loads > scenes / 4);
}

Scene periodic_scene(std::int64_t n, std::uint64_t seed) {
  Scene scene;
  scene.system.boundary = RC_BOUNDARY_PERIODIC;
  scene.system.nx = scene.system.ny = n;
  scene.system.hx = scene.system.hy = 1;
  scene.system.modulus = 1;
  rc_surface_spectral_spec spec = RC_SURFACE_SPECTRAL_SPEC_INIT;
  spec.seed = seed;
  spec.nx = spec.ny = n;
  spec.rms_height = 0;
  spec.rms_slope = 0.1;
  spec.q_rolloff = 2 * 3.14159265358979 / 32;
  spec.q_high = 2 * 3.14159265358979 / 8;
  scene.gap.resize(static_cast<std::size_t>(n * n));
  if (rc_surface_spectral(&spec, scene.gap.data()) != RC_OK) fail_msg("%s", rc_surface_last_error());
  require_usable(rc_gap_from_heights(n * n, RC_IN(scene.gap.data()), {}, RC_OUT(scene.gap.data())), "gap");
  return scene;
}

rc_flow_closing closing(const Scene& scene, std::int32_t along, double width) {
  rc_flow_spec spec = RC_FLOW_SPEC_INIT;
  spec.along = along;
  spec.width = width;
  const rc_step step = scene.step(RC_CONTROL_LOAD, 0);
  rc_flow_closing found = RC_FLOW_CLOSING_INIT;
  if (RC_FAILED(rc_flow_closing_pressure(&scene.system, nullptr, &step, &spec, &found))) fail_msg("%s", rc_flow_last_error());
  return found;
}

void a_seal_is_open_below_its_closing_pressure_and_closed_above(void**) {
  for (const double hardness : {0.0, 0.05}) {
    Scene scene = periodic_scene(64, 3);
    scene.system.hardness = hardness;
    const double area = static_cast<double>(scene.points());
    for (const std::int32_t along : {RC_FLOW_X, RC_FLOW_Y}) {
      const rc_flow_closing found = closing(scene, along, 0.01);
      assert_int_equal(found.status, RC_OK);
      assert_true(found.lower > 0 && found.upper - found.lower <= 0.01 * found.upper);
      assert_true(scene.leak(scene.solved(RC_CONTROL_LOAD, found.lower * 0.999 * area, 1e-10), along).lower > 0);
      assert_true(scene.leak(scene.solved(RC_CONTROL_LOAD, found.upper * 1.001 * area, 1e-10), along).upper == 0);
      assert_true(found.area_fraction > 0.2 && found.constriction > 0 && found.steps > 3);
    }
  }
}

void a_wall_of_excluded_points_is_closed_without_a_load(void**) {
  Scene scene = periodic_scene(48, 4);
  scene.mask.assign(scene.points(), 1);
  for (std::size_t y = 0; y < 48; ++y) scene.mask[y * 48 + 20] = 0;
  const rc_flow_closing found = closing(scene, RC_FLOW_X, 0.01);
  assert_true(found.status == RC_OK && found.lower == 0 && found.upper == 0);
}

// The interval's width over the flow at tol 1e-8, at the returned approach, well open and 1 % of the load short of closing.
void intervals_at_tol_1e_8_are_narrow(void**) {
  const Scene scene = periodic_scene(96, 9);
  const double area = static_cast<double>(scene.points());
  const double closes = closing(scene, RC_FLOW_X, 2e-3).lower;
  const rc_flow_result wide_open = scene.leak(scene.solved(RC_CONTROL_LOAD, 0.2 * closes * area, 1e-8), RC_FLOW_X);
  const rc_flow_result near = scene.leak(scene.solved(RC_CONTROL_LOAD, 0.99 * closes * area, 1e-8), RC_FLOW_X);
  print_message("widths %.1e and, near closing, %.1e\n", 1 - wide_open.lower / wide_open.upper, 1 - near.lower / near.upper);
  assert_true(wide_open.upper - wide_open.lower <= 1e-3 * wide_open.upper);
  assert_true(near.upper - near.lower <= 1e-2 * near.upper);
}

void full_contact_has_no_interval(void**) {
  const Scene scene = periodic_scene(48, 5);
  const Solution full = scene.solved(RC_CONTROL_LOAD, 2 * static_cast<double>(scene.points()), 1e-8);
  if (!std::isnan(full.result.gap_error)) fail_msg("a gap is proven");
  const rc_flow_result found = scene.leak(full, RC_FLOW_X);
  assert_true(found.lower == 0 && std::isinf(found.upper) && found.status == RC_STOP_STALLED && found.flow == 0);
  Solution blind = scene.solved(RC_CONTROL_LOAD, 0.01 * static_cast<double>(scene.points()), 1e-8);
  blind.result.gap_error = NAN;  // as with option bounds 0
  const rc_flow_result unknown = scene.leak(blind, RC_FLOW_X);
  assert_true(unknown.lower == 0 && std::isinf(unknown.upper) && unknown.status == RC_STOP_STALLED && unknown.flow > 0);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(no_exact_flow_lies_outside_of_a_loose_contacts_interval),
      cmocka_unit_test(a_seal_is_open_below_its_closing_pressure_and_closed_above),
      cmocka_unit_test(a_wall_of_excluded_points_is_closed_without_a_load),
      cmocka_unit_test(intervals_at_tol_1e_8_are_narrow),
      cmocka_unit_test(full_contact_has_no_interval),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
