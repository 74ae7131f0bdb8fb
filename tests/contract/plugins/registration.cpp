// Plugins linked into the host program.
#include "scratch.h"

namespace plugins {

const rc_plugin& linked() {
  const rc_plugin* plugin = nullptr;
  assert_int_equal(rc_builtin_linked(nullptr, &plugin), RC_OK);
  return *plugin;
}

namespace {

void a_linked_plugin_is_registered_and_solves() {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  assert_int_equal(rc_context_register(registry.get(), &linked()), RC_OK);
  assert_string_equal(registry.origin("linked").c_str(), "registered");
  assert_true(registry.load("nnls", "linked") > 0);
  assert_true(registry.load("polonsky-keer", "linked") > 0);
}

void the_same_plugin_is_registered_only_once() {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  assert_int_equal(rc_context_register(registry.get(), &linked()), RC_OK);
  const std::int64_t count = rc_component_count(registry.get(), RC_COMPONENT_BACKEND),
                     options = rc_component_count(registry.get(), RC_COMPONENT_OPTION);
  assert_int_equal(rc_context_register(registry.get(), &linked()), RC_ERR_PLUGIN);
  assert_message_has("rc_context_register: plugin \"linked\" (registered): a component named \"linked\" is registered already");
  assert_int_equal(rc_component_count(registry.get(), RC_COMPONENT_BACKEND), count);
  assert_int_equal(rc_component_count(registry.get(), RC_COMPONENT_OPTION), options);
}

void contexts_do_not_share_what_is_registered() {
  const Registry one("", RC_CONTEXT_NO_PLUGINS), other("", RC_CONTEXT_NO_PLUGINS);
  assert_int_equal(rc_context_register(one.get(), &linked()), RC_OK);
  assert_int_equal(other.names("linked"), RC_ERR_NO_BACKEND);
}

rc_status any_shifted(void*, double, const double*, double*) { return RC_OK; }
rc_status any_norm(void*, double*) { return RC_OK; }
const rc_backend* const no_backend[] = {nullptr, nullptr};
const rc_component* const no_option[] = {nullptr};
rc_component option_named_tol, option_with_a_wrong_default;

// One member of a plugin or of its second backend changed, and the reason for which it is refused; null: it is not.
struct Spoilt {
  void (*spoil)(rc_plugin&, rc_backend&);
  const char* reason;
};
const Spoilt spoilt[] = {
    {[](rc_plugin&, rc_backend&) {}, nullptr},
    {[](rc_plugin&, rc_backend& b) { b.struct_size = sizeof b + 800; }, nullptr},
    {[](rc_plugin& p, rc_backend&) { p.struct_size = 8; }, "struct_size 8 is smaller than"},
    {[](rc_plugin& p, rc_backend&) { p.backends = nullptr; }, "a list of components is null"},
    {[](rc_plugin& p, rc_backend&) { p.backends = no_backend; }, "a component is null"},
    {[](rc_plugin&, rc_backend& b) { b.struct_size = 0; }, "a backend has struct_size 0, smaller than"},
    {[](rc_plugin&, rc_backend& b) { b.name = nullptr; }, "a component is named"},
    {[](rc_plugin&, rc_backend& b) { b.name = "a/b"; },
     "a component is named \"a/b\"; names are [a-z][a-z0-9_-]*, at most 31 characters"},
    {[](rc_plugin&, rc_backend& b) { b.name = "abcdefghijklmnopqrstuvwxyzabcdef"; }, "at most 31 characters"},
    {[](rc_plugin&, rc_backend& b) { b.name = "dense"; }, "a component named \"dense\" is registered already"},
    {[](rc_plugin&, rc_backend& b) { b.summary = nullptr; }, "lacks a summary or a licence"},
    {[](rc_plugin&, rc_backend& b) { b.license = nullptr; }, "component \"spoilt\" lacks a summary or a licence"},
    {[](rc_plugin&, rc_backend& b) { b.create = nullptr; }, "lacks one of create, destroy, bind, apply, field, modelled"},
    {[](rc_plugin&, rc_backend& b) { b.destroy = nullptr; }, "lacks one of create"},
    {[](rc_plugin&, rc_backend& b) { b.bind = nullptr; }, "lacks one of create"},
    {[](rc_plugin&, rc_backend& b) { b.apply = nullptr; }, "lacks one of create"},
    {[](rc_plugin&, rc_backend& b) { b.field = nullptr; }, "lacks one of create"},
    {[](rc_plugin&, rc_backend& b) { b.modelled = nullptr; }, "lacks one of create"},
    {[](rc_plugin&, rc_backend& b) { b.options = nullptr, b.n_options = 1; }, "has options, but the list is null"},
    {[](rc_plugin&, rc_backend& b) { b.options = no_option, b.n_options = 1; }, "option 0 is null"},
    {[](rc_plugin&, rc_backend& b) { b.caps |= RC_CAP_SUBSET; }, "backend \"spoilt\" has no subset() but its caps say otherwise"},
    {[](rc_plugin&, rc_backend& b) { b.caps |= RC_CAP_SHIFTED; }, "has no shifted() but its caps say otherwise"},
    {[](rc_plugin&, rc_backend& b) { b.caps |= RC_CAP_NORM; }, "has no norm() but its caps say otherwise"},
    {[](rc_plugin&, rc_backend& b) { b.shifted = any_shifted; }, "has shifted() but its caps say otherwise"},
    {[](rc_plugin&, rc_backend& b) { b.norm = any_norm; }, "has norm() but its caps say otherwise"},
    {[](rc_plugin&, rc_backend& b) {
       option_named_tol = *linked().backends[0]->options[0];
       option_named_tol.name = "tol";
       static const rc_component* const list[] = {&option_named_tol};
       b.options = list, b.n_options = 1;
     },
     "declares the option \"tol\"; its keys must start with \"spoilt.\""},
    {[](rc_plugin&, rc_backend& b) {
       option_with_a_wrong_default = *linked().backends[0]->options[0];
       option_with_a_wrong_default.name = "spoilt.order";
       option_with_a_wrong_default.default_value = "diagonals";
       static const rc_component* const list[] = {&option_with_a_wrong_default};
       b.options = list, b.n_options = 1;
     },
     "the default of an option does not fit: option \"spoilt.order\" = \"diagonals\""},
};

// All or nothing: neither the first backend nor its options are there afterwards.
void spoilt_descriptions_are_refused() {
  for (const Spoilt& each : spoilt) {
    const Registry registry("", RC_CONTEXT_NO_PLUGINS);
    const std::int64_t options = rc_component_count(registry.get(), RC_COMPONENT_OPTION);
    rc_backend second = *linked().backends[1];
    second.name = "spoilt";
    const rc_backend* const list[] = {linked().backends[0], &second};
    rc_plugin plugin = linked();
    plugin.backends = list;
    each.spoil(plugin, second);
    assert_int_equal(rc_context_register(registry.get(), &plugin), each.reason ? RC_ERR_PLUGIN : RC_OK);
    if (!each.reason) continue;
    assert_message_has(each.reason);
    assert_false(registry.lists("linked"));
    assert_int_equal(rc_component_count(registry.get(), RC_COMPONENT_OPTION), options);
  }
}

rc_status no_step(const rc_host*, const rc_problem*, const rc_options*, double*, double*) { return RC_STOP_STALLED; }

// Rows are for solvers that are built into the library.
void a_solver_that_takes_rows_is_refused() {
  rc_solver solver = support::solver("by-rows", no_step);
  assert_int_equal(Registry("", RC_CONTEXT_NO_PLUGINS).add(solver), RC_OK);
  solver.needs = RC_TAKES_ROWS;
  assert_int_equal(Registry("", RC_CONTEXT_NO_PLUGINS).add(solver), RC_ERR_PLUGIN);
  assert_message_has("solver \"by-rows\" takes rows, which only solvers built into the library can");
}

// A backend that goes wrong once it is in use. Twice: a failed step must leave the contact usable.
template <class Change> void assert_solve_gives(rc_status expected, const char* message, const Change& change) {
  rc_backend backend = *linked().backends[0];
  change(backend);
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  assert_int_equal(registry.add(backend), RC_OK);
  pairs::Problem problem;
  problem.system.nx = 2;
  problem.gap = {0, 0.1};
  problem.target = 1;
  Pressed pressed(registry, problem, {{RC_OPT_BACKEND, "linked"}});
  for (int attempt = 0; attempt < 2; ++attempt, pressed.again()) {
    assert_int_equal(pressed.status, expected);
    assert_message_has(message);
  }
}

rc_status failing_create(const rc_host* host, const rc_operator_spec*, void**) {
  return host->fail(host, RC_ERR_MEMORY, "no room on the device");
}
rc_status silent_failure(void*, const rc_domain*) { return RC_ERR_INTERNAL; }

void failures_of_a_backend_in_use_are_passed_on() {
  assert_solve_gives(RC_ERR_MEMORY, "rc_contact_solve: no room on the device", [](rc_backend& b) { b.create = failing_create; });
  assert_solve_gives(RC_ERR_INTERNAL, "binding the trial set failed with RC_ERR_INTERNAL",
                     [](rc_backend& b) { b.bind = silent_failure; });
}

void products_that_are_not_finite_are_not_an_answer() {
  assert_solve_gives(RC_ERR_NUMERIC, "rc_contact_solve: ", [](rc_backend& b) {
    b.apply = b.field = [](void*, const double*, double* y) {
      y[0] = y[1] = __builtin_nan("");
      return rc_status{RC_OK};
    };
  });
}

void a_product_that_is_wrong_is_uncertified() {
  assert_solve_gives(RC_UNCERTIFIED, "the solver claimed success, the library's own check disagrees", [](rc_backend& b) {
    b.field = [](void*, const double* x, double* y) {
      y[0] = 2 * x[0];
      y[1] = 2 * x[1];
      return rc_status{RC_OK};
    };
  });
}

}  // namespace

std::vector<pairs::Test> registration_tests() {
  return {
      TEST(a_linked_plugin_is_registered_and_solves),
      TEST(the_same_plugin_is_registered_only_once),
      TEST(contexts_do_not_share_what_is_registered),
      TEST(spoilt_descriptions_are_refused),
      TEST(a_solver_that_takes_rows_is_refused),
      TEST(failures_of_a_backend_in_use_are_passed_on),
      TEST(products_that_are_not_finite_are_not_an_answer),
      TEST(a_product_that_is_wrong_is_uncertified),
  };
}

}  // namespace plugins
