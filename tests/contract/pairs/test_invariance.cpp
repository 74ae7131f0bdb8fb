// Changes of a problem that must change the answer in a known way or not at all, by every pair: units bit by bit, what warm
// starts save, a spike.
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

struct Units {
  double cell, height, modulus;
  double pressure() const { return modulus * height / cell; }
  double force() const { return pressure() * cell * cell; }
};

Problem in_units(Problem problem, const Units& units) {
  rc_system& s = problem.system;
  s.hx *= units.cell;
  s.hy *= units.cell;
  s.modulus *= units.modulus;
  for (double& value : problem.gap) value *= units.height;
  problem.target *= problem.control == RC_CONTROL_LOAD ? units.force() : units.height;
  return problem;
}

Field scaled(Field values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

// Four to the power of k also has an exact square root.
void powers_of_two_are_exact(std::int32_t boundary, const Pair& pair) {
  Problem elastic = rough_problem(18, 14, boundary, 0.5, 0.75);
  elastic.target *= 1.4;
  for (const Problem& problem : {elastic, at_load(elastic, solved(elastic, pair).result.load)}) {
    const Answer answer = solved(problem, pair);
    for (const Units& units :
         {Units{1 / 1024.0, 1 / 1024.0, 1}, Units{1, 1 / 32.0, 1}, Units{1, 1, 1048576}, Units{4096, 16, 1 / 128.0}}) {
      const Answer other = solved(in_units(problem, units), pair);
      check_same(other.p, scaled(answer.p, units.pressure()), "p");
      check_same(other.gap, scaled(answer.gap, units.height), "gap");
      check_same({other.result.kkt_dual, other.result.kkt_complementarity},
                 {answer.result.kkt_dual, answer.result.kkt_complementarity}, "residuals");
      check_equal(other.result.products, answer.result.products, "products");
    }
  }
}

// Up in ten steps, or four in the reduced set, and down again. That warm steps are right is a property of tests/scenes.
void warm_steps_cost_less(std::int32_t boundary, const Pair& pair) {
  Problem problem = rough_problem(28, 22, boundary, 0.5, 0.75);
  problem.target *= 1.4;
  const double load = solved(problem, pair).result.load;
  const int steps = quick() ? 4 : 10;
  for (const std::int32_t control : controls) {
    std::int64_t products[2] = {0, 0};  // cold, warm
    for (const std::int32_t warm : {0, 1}) {
      const Contact contact(problem, pair);
      rc_step step = problem.step();
      step.control = control;
      step.warm_start = warm;
      for (int k = 0; k < 2 * steps; ++k) {
        step.target = (control == RC_CONTROL_LOAD ? load : problem.target) * (k < steps ? k + 1 : 2 * steps - k - 0.3) / steps;
        const Answer answer = contact.solve(step);
        check_status(answer, RC_OK);
        products[warm] += answer.result.products;
      }
    }
    if (!gains_from_a_start(pair) || quick()) continue;  // steps of the reduced set are far apart
    check(products[1] < products[0], std::to_string(products[1]) + " products warm, " + std::to_string(products[0]) + " cold");
  }
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

std::vector<Test> all_tests() {
  std::vector<Test> tests;
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    const auto add = [&](const char* name, void (*body)(std::int32_t, const Pair&)) {
      add_for_pairs(tests, name, boundary, [=](const Pair& pair) { body(boundary, pair); });
    };
    add("powers_of_two_scale_the_answer_bit_by_bit", powers_of_two_are_exact);
    add("warm_steps_up_and_down_cost_less_than_cold_ones", warm_steps_cost_less);
  }
  add_for_pairs(tests, "spike_is_pressed_into_the_plane_below_it", RC_BOUNDARY_FREE, spike_is_pressed_into_the_plane_below_it);
  return tests;
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) { return pairs::run_group("pairs.invariance", pairs::all_tests(), argc, argv); }
