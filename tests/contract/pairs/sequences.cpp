// Loading sequences: what warm starts save, steps without a gap, steps that nearly lose contact.
#include <cmath>

#include "invariance_tests.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

Problem sequence_problem(std::int32_t boundary) {
  Problem problem = rough_problem(28, 22, boundary, 0.5, 0.75);
  problem.target *= 1.4;
  return problem;
}

// Up in ten steps, or four in the reduced set, and down again.
Field up_and_down(double top) {
  const int steps = quick() ? 4 : 10;
  Field targets;
  for (int k = 1; k <= steps; ++k) targets.push_back(top * k / steps);
  for (int k = steps; k >= 1; --k) targets.push_back(top * (k - 0.3) / steps);
  return targets;
}

void warm_equals_cold(std::int32_t boundary, const Pair& pair) {
  const Problem problem = sequence_problem(boundary);
  const double load = solved(problem, pair).result.load;
  for (const std::int32_t control : controls) {
    const Contact warm(problem, pair), cold(problem, pair);
    std::int64_t warm_products = 0, cold_products = 0;
    rc_step step = problem.step();
    step.control = control;
    for (const double target : up_and_down(control == RC_CONTROL_LOAD ? load : problem.target)) {
      step.target = target;
      step.warm_start = 1;
      const Answer from_last = warm.solve(step);
      step.warm_start = 0;
      const Answer fresh = cold.solve(step);
      check_status(from_last, RC_OK, "warm");
      check_status(fresh, RC_OK, "cold");
      check_near(from_last.p, fresh.p, 1e-9, "p");
      check_near(from_last.result.approach, fresh.result.approach, 1e-10 * problem.target, "approach");
      warm_products += from_last.result.products;
      cold_products += fresh.result.products;
    }
    if (!gains_from_a_start(pair) || quick()) continue;  // steps of the reduced set are far apart
    check(warm_products < cold_products, std::string(control == RC_CONTROL_LOAD ? "load: " : "approach: ") +
                                             std::to_string(warm_products) + " products warm, " + std::to_string(cold_products) +
                                             " cold");
  }
}

void gap_and_mask_are_kept(std::int32_t boundary, const Pair& pair) {
  Problem problem = sequence_problem(boundary);
  problem.mask.assign(problem.points(), 1);
  for (std::size_t i = 0; i < problem.points(); i += 7) problem.mask[i] = 0;
  const Contact contact(problem, pair);
  check_status(contact.solve(problem), RC_OK);

  rc_step step = problem.step();
  step.warm_start = 0;
  step.target *= 0.9;
  Problem lower = problem;
  lower.target = step.target;
  step.undeformed_gap.data = nullptr;
  step.mask.data = nullptr;
  check_near(contact.solve(step).p, solved(lower, pair).p, 1e-9, "p with gap and mask of the step before");

  lower.mask.assign(lower.points(), 1);
  for (std::size_t i = 3; i < lower.points(); i += 5) lower.mask[i] = 0;
  step.mask.data = lower.mask.data();
  check_near(contact.solve(step).p, solved(lower, pair).p, 1e-9, "p with the gap of the step before and another mask");

  lower.mask.clear();
  step.mask.data = nullptr;
  step.undeformed_gap.data = lower.gap.data();
  check_near(contact.solve(step).p, solved(lower, pair).p, 1e-9, "p with a gap and no mask");
}

void nothing_touches(std::int32_t boundary, const Pair& pair) {
  const Problem problem = sequence_problem(boundary);
  const Contact contact(problem, pair);
  const Answer loaded = contact.solve(problem);
  check_status(loaded, RC_OK);
  rc_step step = problem.step();
  for (const double target : {0.0, -1.0}) {
    step.target = target;
    const Answer answer = contact.solve(step);
    check_status(answer, RC_OK);
    check_near(answer.p, Field(problem.points(), 0.0), 0, "p");
    check_near(answer.gap[5], problem.gap[5] - target, 1e-15, "gap");
    check_equal(answer.result.candidates, boundary == RC_BOUNDARY_PERIODIC ? answer.result.points : 0, "candidates");
  }
  step.control = RC_CONTROL_LOAD;
  step.target = 0;
  const Answer unloaded = contact.solve(step);
  check_status(unloaded, RC_OK);
  check_near(unloaded.result.approach, problem.lowest_gap(), 0, "approach of no load");
  step.target = 1e-3 * loaded.result.load;
  check_status(contact.solve(step), RC_OK, "a light load after none");
  check_status(contact.solve(problem), RC_OK, "the step after");
}

// The load control of conjugate gradients goes in circles here: the spike takes its whole load or none.
void spike_is_pressed_into_the_plane_below_it(const Pair& pair) {
  Problem problem;
  problem.system.nx = 30;
  problem.system.ny = 26;
  problem.gap.assign(problem.points(), 1.0);
  problem.gap[337] = 0;
  for (const double approach : {1.01, 1.03, 1.2}) {
    problem.target = approach;
    const Answer there = solved(problem, pair);
    const Answer back = solved(at_load(problem, there.result.load), pair);
    check_near(back.result.approach, approach, 1e-8, "approach");
  }
}

// The pressures of full contact are far beyond those of a light step, and with periodic boundaries their mean costs nothing.
void light_step_after_full_contact(const Pair& pair) {
  const Problem problem = sequence_problem(RC_BOUNDARY_PERIODIC);
  const Answer light = solved(problem, pair);
  const Contact contact(problem, pair);
  rc_step step = problem.step();
  step.control = RC_CONTROL_LOAD;
  step.target = 1e3 * light.result.load;
  check_status(contact.solve(step), RC_OK, "heavy");
  check_near(contact.solve(problem).p, light.p, 1e-9, "p of the light step");
}

}  // namespace

std::vector<Test> sequence_tests() {
  std::vector<Test> tests;
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    const auto add = [&](const char* name, void (*body)(std::int32_t, const Pair&)) {
      add_for_pairs(tests, name, boundary, [=](const Pair& pair) { body(boundary, pair); });
    };
    add("warm_steps_up_and_down_equal_cold_ones_and_cost_less", warm_equals_cold);
    add("step_without_gap_keeps_gap_and_mask", gap_and_mask_are_kept);
    add("nothing_touches_below_the_lowest_gap_or_without_load", nothing_touches);
  }
  add_for_pairs(tests, "spike_is_pressed_into_the_plane_below_it", RC_BOUNDARY_FREE, spike_is_pressed_into_the_plane_below_it);
  add_for_pairs(tests, "light_step_after_full_contact", RC_BOUNDARY_PERIODIC, light_step_after_full_contact);
  return tests;
}

}  // namespace pairs
