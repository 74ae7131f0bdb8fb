// Units: lengths, heights and the modulus by powers of two scale every bit of the answer and nothing else.
#include "invariance_tests.h"
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

// In both controls.
template <class Check> void in_both_controls(std::int32_t boundary, const Pair& pair, const Check& compare) {
  Problem problem = rough_problem(18, 14, boundary, 0.5, 0.75);
  problem.target *= 1.4;
  const Answer answer = solved(problem, pair);
  compare(problem, answer);
  const Problem loaded = at_load(problem, answer.result.load);
  compare(loaded, solved(loaded, pair));
}

// Four to the power of k also has an exact square root.
void powers_of_two_are_exact(std::int32_t boundary, const Pair& pair) {
  in_both_controls(boundary, pair, [&](const Problem& problem, const Answer& answer) {
    for (const Units& units :
         {Units{1 / 1024.0, 1 / 1024.0, 1}, Units{1, 1 / 32.0, 1}, Units{1, 1, 1048576}, Units{4096, 16, 1 / 128.0}}) {
      const Answer other = solved(in_units(problem, units), pair);
      check_same(other.p, scaled(answer.p, units.pressure()), "p");
      check_same(other.gap, scaled(answer.gap, units.height), "gap");
      check_same({other.result.kkt_dual, other.result.kkt_complementarity},
                 {answer.result.kkt_dual, answer.result.kkt_complementarity}, "residuals");
      check_equal(other.result.products, answer.result.products, "products");
    }
  });
}

}  // namespace

std::vector<Test> unit_tests() {
  std::vector<Test> tests;
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    const auto add = [&](const char* name, void (*body)(std::int32_t, const Pair&)) {
      add_for_pairs(tests, name, boundary, [=](const Pair& pair) { body(boundary, pair); });
    };
    add("powers_of_two_scale_the_answer_bit_by_bit", powers_of_two_are_exact);
  }
  return tests;
}

}  // namespace pairs
