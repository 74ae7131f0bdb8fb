// Units: lengths, heights and the modulus scale the answer and nothing else.
#include <cmath>

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

void units_scale_the_answer(std::int32_t boundary, const Pair& pair) {
  in_both_controls(boundary, pair, [&](const Problem& problem, const Answer& answer) {
    for (const Units& units :
         {Units{1e-9, 1e-9, 1}, Units{1, 1e-9, 1}, Units{1, 1, 1e11}, Units{1, 1, 1e-11}, Units{1e-6, 1e-9, 1e11}}) {
      const Answer other = solved(in_units(problem, units), pair);
      check_near(other.p, scaled(answer.p, units.pressure()), 1e-10, "p");
      check_near(other.result.load, answer.result.load * units.force(), 1e-11 * answer.result.load * units.force(), "load");
      check_near(other.result.approach, answer.result.approach * units.height, 1e-10 * units.height, "approach");
      check_near(other.result.energy, answer.result.energy * units.force() * units.height,
                 1e-10 * std::abs(answer.result.energy) * units.force() * units.height, "energy");
      check_equal(other.result.contacts, answer.result.contacts, "contacts");
    }
  });
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

void datum_does_not_matter(std::int32_t boundary, const Pair& pair) {
  in_both_controls(boundary, pair, [&](const Problem& problem, const Answer& answer) {
    for (const double datum : {8.0, -8.0, 1000.0}) {
      Problem shifted = problem;
      for (double& value : shifted.gap) value += datum;
      if (problem.control == RC_CONTROL_APPROACH) shifted.target += datum;
      const Answer other = solved(shifted, pair, {{RC_OPT_TOL, "1e-11"}});
      check_near(other.p, answer.p, 1e-9, "p");
      check_near(other.result.approach, answer.result.approach + datum, 1e-12 * std::abs(datum), "approach");
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
    add("units_scale_the_answer", units_scale_the_answer);
    add("powers_of_two_scale_the_answer_bit_by_bit", powers_of_two_are_exact);
    add("constant_added_to_gap_and_approach_changes_nothing", datum_does_not_matter);
  }
  return tests;
}

}  // namespace pairs
