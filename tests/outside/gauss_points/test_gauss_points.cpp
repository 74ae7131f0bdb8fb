// Forces are those of the library called directly, tangents those of finite differences, and threads change no bit.
#include <roughcontact/surface.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "chain.h"
#include "contact_law.h"
#include "support/cmocka.hpp"
#include "support/unit_system.h"
#include "topography.h"

namespace {

constexpr int side = 32;

std::vector<double> rough(std::uint64_t seed) {
  rc_surface_spectral_spec spec = RC_SURFACE_SPECTRAL_SPEC_INIT;
  spec.seed = seed;
  spec.nx = spec.ny = side;
  std::vector<double> heights(side * side);
  assert_int_equal(rc_surface_spectral(&spec, heights.data()), RC_OK);
  return heights;
}

rc_system grid() {
  rc_system system = support::unit_system();
  system.nx = system.ny = side;
  system.modulus = 2;
  return system;
}

double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

// The library's load without the law around it.
double direct_load(const std::vector<double>& heights, double displacement) {
  std::vector<double> gap;
  for (const double z : heights) gap.push_back(largest(heights) - z);
  const rc_system system = grid();
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_APPROACH;
  step.target = displacement;
  step.undeformed_gap.data = gap.data();
  rc_options* options = nullptr;
  assert_int_equal(rc_options_create(nullptr, &options), RC_OK);
  assert_int_equal(rc_options_set_number(options, RC_OPT_TOL, 1e-10), RC_OK);
  assert_int_equal(rc_options_set_number(options, RC_OPT_STIFFNESS, 1), RC_OK);
  rc_result result = RC_RESULT_INIT;
  assert_int_equal(rc_solve(&system, &step, options, &result), RC_OK);
  rc_options_destroy(options);
  return result.load;
}

bool close(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance * std::abs(b); }

void forces_are_those_of_direct_solves(void**) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const std::vector<double> heights = rough(seed);
    ContactLaw fresh(grid(), heights), loaded(grid(), heights);
    for (const double displacement : {0.1, 0.7, 0.3, 1.5}) {
      const double expected = direct_load(heights, displacement);
      assert_true(fresh.evaluate(displacement).force == expected);  // nothing committed: the same start, the same bits
      assert_true(close(loaded.evaluate(displacement).force, expected, 1e-8));
      loaded.commit();
    }
  }
}

void tangents_are_those_of_finite_differences(void**) {
  for (const bool subtract : {false, true}) {
    ContactLaw law(grid(), rough(4), {{"tol", "1e-12"}, {"solver", "nnls"}});
    if (subtract) law.subtract_bulk(ContactLaw::square_stiffness(2, side));
    for (const double displacement : {0.2, 0.6, 1.2}) {
      const double h = 1e-5 * displacement;
      const ContactLaw::Answer here = law.evaluate(displacement);
      const double slope = (law.evaluate(displacement + h).force - law.evaluate(displacement - h).force) / (2 * h);
      if (!close(here.tangent, slope, 1e-3))
        fail_msg("displacement %g: tangent %.10g, differences %.10g", displacement, here.tangent, slope);
    }
  }
}

// The force at a displacement without the bulk is the one of the whole patch at that displacement plus what the bulk gives way.
void subtracting_the_bulk_moves_the_displacement(void**) {
  const std::vector<double> heights = rough(5);
  const double stiffness = ContactLaw::square_stiffness(2, side);
  ContactLaw law(grid(), heights);
  law.subtract_bulk(stiffness);
  const double force = law.evaluate(0.8).force;
  assert_true(close(direct_load(heights, 0.8 + force / stiffness), force, 1e-6));
}

void trials_do_not_depend_on_the_trials_before(void**) {
  ContactLaw law(grid(), rough(6));
  law.evaluate(0.5);
  law.commit();
  const ContactLaw::State state = law.state();
  const ContactLaw::Answer first = law.evaluate(0.6);
  law.evaluate(2);
  law.evaluate(0.01);
  const ContactLaw::Answer again = law.evaluate(0.6);
  assert_true(first.force == again.force && first.tangent == again.tangent);
  law.commit();
  assert_true(law.state().pressures != state.pressures);
  law.restore(state);
  assert_true(law.evaluate(0.6).force == first.force);
}

// One that takes its law where it holds, and one that always solves, on the same way in and out.
void the_law_is_taken_where_the_history_allows_it(void**) {
  constexpr double tolerance = 1e-3;
  for (const double hardness : {0.0, 0.2}) {
    rc_system system = grid();
    system.hardness = hardness;
    ContactLaw law(system, rough(8)), solver(system, rough(8));
    law.tabulate(1e-3, 5e-2, tolerance);
    struct Step {
      double displacement;
      bool first_loading;
    };
    for (const auto& [displacement, first_loading] :
         {Step{0.5, true}, Step{0.7, true}, Step{0.6, false}, Step{0.65, false}, Step{0.75, true}, Step{0.4, false}}) {
      const ContactLaw::Answer answer = law.evaluate(displacement), solved = solver.evaluate(displacement);
      assert_int_equal(answer.tabulated, first_loading || hardness == 0);
      assert_false(solved.tabulated);
      if (!close(answer.force, solved.force, 3 * tolerance))
        fail_msg("hardness %g, displacement %g: %.10g, solved %.10g", hardness, displacement, answer.force, solved.force);
      law.commit();
      solver.commit();
    }
    const double indentation = law.state().indentation.empty() ? 0 : largest(law.state().indentation);
    assert_int_equal(indentation > 0, hardness > 0);
    assert_false(law.evaluate(1e-6).tabulated);  // below the law
    assert_false(law.evaluate(3).tabulated);     // beyond it
  }
}

void no_contact_no_force(void**) {
  ContactLaw law(grid(), rough(7));
  for (const double displacement : {0.0, -1.0}) {
    const ContactLaw::Answer answer = law.evaluate(displacement);
    assert_true(answer.force == 0 && answer.tangent == 0);
    law.commit();
  }
  assert_true(law.evaluate(0.1).force > 0);
}

std::string message(const auto& act) {
  try {
    act();
  } catch (const std::runtime_error& failure) {
    return failure.what();
  }
  return "";
}

void failures_are_exceptions_with_the_message(void**) {
  assert_non_null(std::strstr(message([] { ContactLaw(grid(), std::vector<double>(7, 0.0)); }).c_str(), "7 heights"));
  assert_non_null(std::strstr(message([] { ContactLaw(grid(), rough(1), {{"solvr", "nnls"}}); }).c_str(), "solver"));
  ContactLaw law(grid(), rough(1));
  assert_non_null(std::strstr(message([&] { law.evaluate(INFINITY); }).c_str(), "target"));
  // One failing point among others: its message, and no thread is left behind.
  std::vector<ContactLaw> laws;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) laws.emplace_back(grid(), rough(seed));
  assert_non_null(std::strstr(message([&] { evaluate_all(laws, {0.1, INFINITY, 0.1}, 2); }).c_str(), "target"));
}

Topography topography_of(const std::string& text) {
  std::ofstream("topography.dat") << text;
  return read_topography("topography.dat");
}

void reads_rows_with_and_without_a_last_semicolon(void**) {
  for (const char* text : {"1;2\n3;4\n", "1;2;\n3;4;\n", "1; 2\r\n 3.0 ;4e0\r\n\n", "+1;2\n3;+4"}) {
    const Topography map = topography_of(text);
    assert_int_equal(map.side, 2);
    assert_true((map.heights == std::vector<double>{1, 2, 3, 4}));
  }
  assert_true(topography_of("-1.25e-3").heights.front() == -1.25e-3);
}

void refuses_files_with_line_and_reason(void**) {
  for (const auto& [text, part] : {std::pair{"", "no values"},
                                   {"1;2\n3;four\n", "line 2: value 2, \"four\""},
                                   {"1;2\n3;nan\n", "not a finite number"},
                                   {"1;;2\n", "value 2, \"\""},
                                   {"1;2\n3\n", "line 2: 1 values; the first line has 2"},
                                   {"1;2\n", "1 lines of 2 values; give a square map"},
                                   {"1 2\n3 4\n", "\"1 2\""}})
    assert_non_null(std::strstr(message([text = text] { topography_of(text); }).c_str(), part));
  assert_non_null(std::strstr(message([] { read_topography("/nowhere/at/all"); }).c_str(), "cannot be opened"));
}

std::vector<ChainStep> chain_with(int threads) {
  std::vector<ContactLaw> laws;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) laws.emplace_back(grid(), rough(seed));
  Chain chain;
  chain.spring = 3;
  chain.push = 0.5;
  chain.position.assign(laws.size(), -0.1);
  chain.velocity.assign(laws.size(), 0.6);
  return run(chain, laws, 0.2, 12, threads);
}

void threads_change_no_bit_of_a_time_loop(void**) {
  const std::vector<ChainStep> one = chain_with(1), two = chain_with(2), three = chain_with(3);
  assert_int_equal(one.size(), 12);
  double most = 0;
  for (std::size_t k = 0; k < one.size(); ++k) {
    assert_true(one[k].position == two[k].position && one[k].position == three[k].position);
    assert_true(one[k].contact_force == two[k].contact_force && one[k].contact_force == three[k].contact_force);
    assert_in_range(one[k].newton_iterations, 0, 8);  // the tangents are right: Newton's method is fast
    most = std::max(most, one[k].contact_force);
  }
  assert_true(most > 1);
  assert_true(one.back().position != one.front().position);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(forces_are_those_of_direct_solves),
      cmocka_unit_test(tangents_are_those_of_finite_differences),
      cmocka_unit_test(subtracting_the_bulk_moves_the_displacement),
      cmocka_unit_test(trials_do_not_depend_on_the_trials_before),
      cmocka_unit_test(the_law_is_taken_where_the_history_allows_it),
      cmocka_unit_test(no_contact_no_force),
      cmocka_unit_test(failures_are_exceptions_with_the_message),
      cmocka_unit_test(threads_change_no_bit_of_a_time_loop),
      cmocka_unit_test(reads_rows_with_and_without_a_last_semicolon),
      cmocka_unit_test(refuses_files_with_line_and_reason),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
