// Plugins that must work.
#include <cmath>

#include "scratch.h"

namespace plugins {

namespace {

void assert_near(double value, double wanted) { pairs::check_near(value, wanted, 1e-8 * std::abs(wanted), "load"); }

void a_naive_backend_serves_every_solver() {
  const Scratch scratch;
  scratch.put({"toy"});
  const Registry registry(scratch.path());
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
    for (const std::int32_t control : {RC_CONTROL_APPROACH, RC_CONTROL_LOAD}) {
      const double wanted = registry.load("nnls", "dense", boundary, control);
      assert_true(wanted > 0);
      for (const char* solver : {"nnls", "polonsky-keer"}) assert_near(registry.load(solver, "toy", boundary, control), wanted);
      assert_string_equal(registry.result().backend, "toy");
    }
}

void a_solver_from_outside_uses_every_backend() {
  const Scratch scratch;
  scratch.put({"toy", "spg"});
  const Registry registry(scratch.path());
  const double wanted = registry.load("nnls", "dense");
  for (const char* backend : {"dense", "toy"}) assert_near(registry.load("spg", backend), wanted);
  assert_string_equal(registry.result().solver, "spg");
  // The core adds load control to a solver that lacks it.
  assert_near(registry.load("spg", "dense", RC_BOUNDARY_FREE, RC_CONTROL_LOAD), 2);
}

void a_fallback_is_named_in_the_result() {
  const Scratch scratch;
  scratch.put({"toy"});
  const Registry registry(scratch.path());
  assert_true(registry.load("nnls", "toy") > 0);
  assert_has(registry.result().note, "backend \"toy\" cannot factor");
}

void a_higher_minor_version_works() {
  const Scratch scratch;
  scratch.put({"future_minor"});
  const Registry registry(scratch.path());
  assert_near(registry.load("polonsky-keer", "future_minor"), registry.load("nnls", "dense"));
}

void a_plugin_is_listed_with_its_file() {
  const Scratch scratch;
  const std::string file = scratch.put({"toy"});
  const Registry registry(scratch.path());
  assert_string_equal(registry.origin("toy").c_str(), file.c_str());
  assert_string_equal(registry.origin("second-of-toy").c_str(), file.c_str());
  assert_string_equal(registry.log().c_str(), "");
}

void a_dotted_option_loads_its_component() {
  const Scratch scratch;
  scratch.put({"toy"});
  const Registry registry(scratch.path());
  const pairs::Options options = pairs::make_options(pairs::automatic, "auto", {{"toy.order", "columns"}}, registry.get());
  assert_int_equal(rc_options_set_text(options.get(), "toy.order", "colums"), RC_ERR_OPTION);
  assert_message_has("option \"toy.order\" = \"colums\" is none of rows|columns; did you mean \"columns\"?");
}

void a_preference_list_passes_over_what_is_refused() {
  const Scratch scratch;
  scratch.put({"bad_abi", "toy"});
  const Registry registry(scratch.path());
  assert_true(registry.load("auto", "nobody,bad_abi,toy,dense") > 0);
  assert_string_equal(registry.result().backend, "toy");
}

void two_contexts_load_the_same_file() {
  const Scratch scratch;
  scratch.put({"toy"});
  const Registry one(scratch.path()), other(scratch.path());
  assert_true(one.load("auto", "toy") > 0);
  assert_true(other.load("auto", "toy") == one.load("auto", "toy"));
}

}  // namespace

std::vector<pairs::Test> good_tests() {
  return {
      TEST(a_naive_backend_serves_every_solver),
      TEST(a_solver_from_outside_uses_every_backend),
      TEST(a_fallback_is_named_in_the_result),
      TEST(a_higher_minor_version_works),
      TEST(a_plugin_is_listed_with_its_file),
      TEST(a_dotted_option_loads_its_component),
      TEST(a_preference_list_passes_over_what_is_refused),
      TEST(two_contexts_load_the_same_file),
  };
}

}  // namespace plugins
