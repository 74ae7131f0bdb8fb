#include <algorithm>

#include "case.h"
#include "scene.h"

namespace errors {

namespace {

template <class Spoil> auto step_with(const Spoil& spoil) {
  return [spoil] {
    Scene scene;
    spoil(scene);
    return solve(scene);
  };
}

auto load(double target) {
  return step_with([=](Scene& scene) {
    scene.step.control = RC_CONTROL_LOAD;
    scene.step.target = target;
  });
}

auto periodic_approach(double target) {
  return [=] {
    Scene scene = periodic_scene();
    scene.step.target = target;
    return solve(scene);
  };
}

// A step with hardness 2 on 16 points.
auto hard(double target, std::initializer_list<std::pair<const char*, const char*>> settings = {},
          std::int32_t control = RC_CONTROL_LOAD) {
  return [=, kept = std::vector(settings)] {
    Scene scene;
    scene.system.hardness = 2;
    scene.step.control = control;
    scene.step.target = target;
    const OptionsHandle options = options_with({});
    for (const auto& [key, value] : kept) assert_int_equal(rc_options_set_text(options.get(), key, value), RC_OK);
    return solve(scene, options.get());
  };
}

Outcome no_contact(Scene& scene) {
  const Outcome outcome = solve(scene);
  assert_true(std::all_of(answer().p().begin(), answer().p().end(), [](double p) { return p == 0; }));
  assert_true(answer().result()->load == 0);
  return outcome;
}

auto untouched_at(double target) {
  return [=] {
    Scene scene;
    scene.step.target = target;
    return no_contact(scene);
  };
}

Outcome all_masked(std::int32_t control, double target) {
  Scene scene;
  const std::vector<std::uint8_t> mask(points, 0);
  std::fill(scene.gap.begin(), scene.gap.end(), nan);
  scene.step.mask.data = mask.data();
  scene.step.control = control;
  scene.step.target = target;
  return target > 0 && control == RC_CONTROL_LOAD ? Outcome(solve(scene)) : no_contact(scene);
}

Outcome nan_under_the_mask() {
  Scene scene;
  std::vector<std::uint8_t> mask(points, 1);
  mask[2] = 0;
  scene.gap[2] = nan;
  scene.step.mask.data = mask.data();
  const Outcome outcome = solve(scene);
  assert_true(answer().p()[2] == 0 && answer().result()->load > 0);
  return outcome;
}

Outcome start_with(double value) {
  Scene scene;
  std::vector<double> p0(points, 0.0);
  p0[5] = value;
  scene.step.p0.data = p0.data();
  return solve(scene);
}

Outcome mask_lifted_over_nan() {
  Scene scene;
  std::vector<std::uint8_t> mask(points, 1);
  mask[2] = 0;
  scene.gap[2] = nan;
  scene.step.mask.data = mask.data();
  const ContactHandle contact = made(scene);
  assert_int_equal(solve(contact.get(), scene), RC_OK);
  answer().prepare();
  mask[2] = 1;
  scene.step.undeformed_gap.data = nullptr;
  return solve(contact.get(), scene);
}

Outcome certify(double value, bool masked) {
  Scene scene;
  std::vector<std::uint8_t> mask(points, 1);
  mask[0] = 0;
  if (masked) scene.step.mask.data = mask.data();
  std::vector<double> p(points, 0.0);
  p[0] = value;
  rc_result result = RC_RESULT_INIT;
  result.p.data = p.data();
  const ContactHandle contact = made(scene);
  return rc_contact_certify(contact.get(), &scene.step, &result);
}

}  // namespace

Section steps() {
  const rc_status refused = RC_ERR_ARGUMENT, infeasible = RC_ERR_INFEASIBLE;
  return {
      "Steps",
      {
          {"control = 0",
           refused,
           {"rc_step.control = 0 is none of RC_CONTROL_APPROACH (1), RC_CONTROL_LOAD (2), RC_CONTROL_AREA (4), "
            "RC_CONTROL_PRESSURE (8)"},
           step_with([](Scene& s) { s.step.control = 0; })},
          {"target = NaN", refused, {"rc_step.target = nan is not finite"}, step_with([](Scene& s) { s.step.target = nan; })},
          {"target = infinity", refused, {"rc_step.target = inf is not finite"}, step_with([](Scene& s) {
             s.step.target = infinity;
           })},
          {"load = NaN", refused, {"rc_step.target = nan is not finite"}, load(nan)},
          {"gap with NaN",
           refused,
           {"gap has 2 value(s) that are not finite, first at ix=3, iy=0 (nan); exclude them with rc_step.mask"},
           step_with([](Scene& s) { s.gap[3] = s.gap[7] = nan; })},
          {"gap with infinity",
           refused,
           {"gap has 1 value(s) that are not finite, first at ix=0, iy=0 (-inf)"},
           step_with([](Scene& s) { s.gap[0] = -infinity; })},
          {"gap with NaN under the mask", RC_OK, {}, nan_under_the_mask},
          {"mask that lifts NaN of the step before",
           refused,
           {"gap has 1 value(s) that are not finite, first at ix=2, iy=0"},
           mask_lifted_over_nan},
          {"p0 with NaN", refused, {"rc_step.p0[5] = nan is not finite (ix=1, iy=1)"}, [] { return start_with(nan); }},
          {"p0 with infinity", refused, {"rc_step.p0[5] = inf is not finite (ix=1, iy=1)"}, [] { return start_with(infinity); }},
          {"p0 negative: taken as 0", RC_OK, {}, [] { return start_with(-1e300); }},
          {"no gap ever given",
           refused,
           {"rc_step.undeformed_gap.data is null and no earlier step gave one"},
           step_with([](Scene& s) { s.step.undeformed_gap.data = nullptr; })},
          {"gap of no type",
           refused,
           {"rc_step.undeformed_gap.type = 7 is neither RC_NATIVE nor RC_SINGLE"},
           step_with([](Scene& s) { s.step.undeformed_gap.type = 7; })},
          {"mask of floats", refused, {"rc_step.mask.type = 1 is not RC_NATIVE"}, step_with([](Scene& s) {
             s.step.mask.type = RC_SINGLE;
           })},
          {"reserved member of an array", refused, {"rc_step.p0.reserved = 1 must be 0"}, step_with([](Scene& s) {
             s.step.p0.reserved = 1;
           })},
          {"memory = \"dense\", which has no device",
           RC_ERR_INCOMPATIBLE,
           {"rc_step.undeformed_gap.memory = \"dense\": this backend has no device with a memory of its own"},
           step_with([](Scene& s) { s.step.undeformed_gap.memory = "dense"; })},
          {"memory = \"nowhere\"", RC_ERR_NO_BACKEND, {"nowhere"}, step_with([](Scene& s) {
             s.step.undeformed_gap.memory = "nowhere";
           })},
          {"warm_start = 9", refused, {"rc_step.warm_start = 9 is neither 0 nor 1"}, step_with([](Scene& s) {
             s.step.warm_start = 9;
           })},
          {"reserved = 5", refused, {"rc_step.reserved = 5 must be 0"}, step_with([](Scene& s) { s.step.reserved = 5; })},
          {"borrow = 2", refused, {"rc_step.borrow = 2 is neither 0 nor 1"}, step_with([](Scene& s) { s.step.borrow = 2; })},
          {"approach at the lowest point: p = 0", RC_OK, {}, untouched_at(0)},
          {"approach below the lowest point: p = 0", RC_OK, {}, untouched_at(-1)},
          {"approach = -1e308: p = 0", RC_OK, {}, untouched_at(-1e308)},
          {"load = 0: p = 0", RC_OK, {}, load(0)},
          {"load = -1",
           infeasible,
           {"load = -1 is negative; a contact without adhesion cannot pull, the smallest load is 0"},
           load(-1)},
          {"every point masked, approach: p = 0", RC_OK, {}, [] { return all_masked(RC_CONTROL_APPROACH, 1); }},
          {"every point masked, load = 0: p = 0", RC_OK, {}, [] { return all_masked(RC_CONTROL_LOAD, 0); }},
          {"every point masked, load = 1",
           infeasible,
           {"load = 1 but every point is excluded by the mask"},
           [] { return all_masked(RC_CONTROL_LOAD, 1); }},
          {"load above hardness times area",
           infeasible,
           {"load = 33 is more than hardness times the area of the 16 points that may carry pressure, 32; prescribe less load, "
            "or "
            "allow more points"},
           hard(33)},
          {"load of hardness times area", RC_OK, {}, hard(32)},
          {"hardness and the solver greedy",
           RC_ERR_INCOMPATIBLE,
           {"solver \"greedy\" knows no largest pressure, but the system has the hardness 2"},
           hard(1, {{"solver", "greedy"}, {"backend", "dense"}})},
          {"hardness and the warm-up greedy",
           RC_ERR_INCOMPATIBLE,
           {"warmup: solver \"greedy\" knows no largest pressure, but the system has the hardness 2"},
           hard(1, {{"solver", "nnls"}, {"backend", "dense"}, {"warmup", "greedy"}}, RC_CONTROL_APPROACH)},
          {"periodic approach beyond the mean plane with a hardness",
           RC_OK,
           {},
           [] {
             Scene scene = periodic_scene();
             scene.system.hardness = 2;
             scene.step.target = 2;
             return solve(scene);
           }},
          {"periodic approach at the mean plane",
           infeasible,
           {"approach = 0.9375 reaches the mean plane of the gap, 0.9375: with periodic boundaries the load is not "
            "determined there; prescribe the load"},
           periodic_approach(0.9375)},
          {"periodic approach beyond the mean plane",
           infeasible,
           {"approach = 2 reaches the mean plane of the gap, 0.9375"},
           periodic_approach(2)},
          {"periodic approach below the mean plane", RC_OK, {}, periodic_approach(0.9)},
          {"periodic approach of 1e-20", RC_OK, {}, periodic_approach(1e-20)},
          {"periodic approach of 1e-60",
           refused,
           {"approach = 1e-60 is above the lowest gap by 1e-60, less than 1e-30 of the gap's range"},
           periodic_approach(1e-60)},
          {"gap whose range overflows",
           refused,
           {"the gap's range, -1e+308 .. 1e+308, and the target 0.55 are too far apart for double precision"},
           step_with([](Scene& s) {
             s.gap[0] = -1e308;
             s.gap[1] = 1e308;
           })},
          {"load = 1e308: the approach overflows", RC_ERR_NUMERIC, {"rc_solve: the answer is not finite"}, load(1e308)},
          {"certify a pressure that is NaN",
           refused,
           {"rc_contact_certify: rc_result.p[0] = nan is not finite (ix=0, iy=0)"},
           [] { return certify(nan, false); }},
          {"certify a pressure under the mask",
           refused,
           {"rc_contact_certify: rc_result.p[0] = 1 but this point is excluded by the mask"},
           [] { return certify(1, true); }},
          {"certify a negative pressure",
           RC_UNCERTIFIED,
           {"rc_contact_certify: ", "kkt_primal 1"},
           [] { return certify(-1, false); }},
      }};
}

}  // namespace errors
