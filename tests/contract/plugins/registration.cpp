// Plugins linked into the host program.
#include "scratch.h"
#include "support/unit_system.h"

namespace plugins {

namespace {

const rc_plugin& linked() {
  const rc_plugin* plugin = nullptr;
  assert_int_equal(rc_builtin_linked(nullptr, &plugin), RC_OK);
  return *plugin;
}

void a_linked_plugin_is_registered_and_solves(void**) {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  assert_int_equal(rc_context_register(registry.get(), &linked()), RC_OK);
  assert_string_equal(registry.origin("linked").c_str(), "registered");
  assert_true(registry.load("nnls", "linked") > 0);
  assert_true(registry.load("polonsky-keer", "linked") > 0);
}

void the_same_plugin_is_registered_only_once(void**) {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  assert_int_equal(rc_context_register(registry.get(), &linked()), RC_OK);
  const std::int64_t count = rc_component_count(registry.get(), RC_COMPONENT_BACKEND),
                     options = rc_component_count(registry.get(), RC_COMPONENT_OPTION);
  assert_int_equal(rc_context_register(registry.get(), &linked()), RC_ERR_PLUGIN);
  assert_message_has("rc_context_register: plugin \"linked\" (registered): a component named \"linked\" is registered already");
  assert_int_equal(rc_component_count(registry.get(), RC_COMPONENT_BACKEND), count);
  assert_int_equal(rc_component_count(registry.get(), RC_COMPONENT_OPTION), options);
}

void contexts_do_not_share_what_is_registered(void**) {
  const Registry one("", RC_CONTEXT_NO_PLUGINS), other("", RC_CONTEXT_NO_PLUGINS);
  assert_int_equal(rc_context_register(one.get(), &linked()), RC_OK);
  assert_int_equal(other.names("linked"), RC_ERR_NO_BACKEND);
}

// Registers a copy with one member changed.
template <class Change> rc_status registered(const Change& change) {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  rc_plugin plugin = linked();
  change(plugin);
  return rc_context_register(registry.get(), &plugin);
}

void spoilt_descriptions_are_refused(void**) {
  assert_int_equal(registered([](rc_plugin&) {}), RC_OK);
  static const rc_backend* const nothing[] = {nullptr, nullptr};
  assert_int_equal(registered([](rc_plugin& p) { p.backends = nothing; }), RC_ERR_PLUGIN);
  assert_message_has("a component is null");
}

// Registers one backend with one member changed.
template <class Change> rc_status backend_registered(const Change& change) {
  static rc_backend backend;
  static const rc_backend* const list[] = {&backend};
  backend = *linked().backends[0];
  change(backend);
  return registered([](rc_plugin& plugin) {
    plugin.n_backends = 1;
    plugin.backends = list;
  });
}

void spoilt_backends_are_refused(void**) {
  assert_int_equal(backend_registered([](rc_backend&) {}), RC_OK);
  assert_int_equal(backend_registered([](rc_backend& b) { b.struct_size = 0; }), RC_ERR_PLUGIN);
  assert_int_equal(backend_registered([](rc_backend& b) { b.struct_size = sizeof b + 800; }), RC_OK);
  assert_int_equal(backend_registered([](rc_backend& b) { b.name = nullptr; }), RC_ERR_PLUGIN);
  assert_int_equal(backend_registered([](rc_backend& b) { b.name = "a/b"; }), RC_ERR_PLUGIN);
  assert_int_equal(backend_registered([](rc_backend& b) { b.name = "abcdefghijklmnopqrstuvwxyzabcdef"; }), RC_ERR_PLUGIN);
  assert_int_equal(backend_registered([](rc_backend& b) { b.summary = nullptr; }), RC_ERR_PLUGIN);
  assert_int_equal(backend_registered([](rc_backend& b) { b.create = nullptr; }), RC_ERR_PLUGIN);
  assert_int_equal(backend_registered([](rc_backend& b) { b.destroy = nullptr; }), RC_ERR_PLUGIN);
  assert_int_equal(backend_registered([](rc_backend& b) { b.bind = nullptr; }), RC_ERR_PLUGIN);
  assert_int_equal(backend_registered([](rc_backend& b) { b.field = nullptr; }), RC_ERR_PLUGIN);
  assert_int_equal(backend_registered([](rc_backend& b) { b.modelled = nullptr; }), RC_ERR_PLUGIN);
  assert_int_equal(backend_registered([](rc_backend& b) { b.options = nullptr; }), RC_ERR_PLUGIN);
  assert_message_has("has options, but the list is null");
  static const rc_component* const nothing[] = {nullptr};
  assert_int_equal(backend_registered([](rc_backend& b) { b.options = nothing; }), RC_ERR_PLUGIN);
  assert_message_has("option 0 is null");
}

rc_status any_shifted(void*, double, const double*, double*) { return RC_OK; }
rc_status any_norm(void*, double*) { return RC_OK; }

void new_operations_and_their_bits_go_together(void**) {
  assert_int_equal(backend_registered([](rc_backend& b) { b.caps |= RC_CAP_SHIFTED; }), RC_ERR_PLUGIN);
  assert_message_has("has no shifted() but its caps say otherwise");
  assert_int_equal(backend_registered([](rc_backend& b) { b.caps |= RC_CAP_NORM; }), RC_ERR_PLUGIN);
  assert_message_has("has no norm() but its caps say otherwise");
  assert_int_equal(backend_registered([](rc_backend& b) { b.shifted = any_shifted; }), RC_ERR_PLUGIN);
  assert_message_has("has shifted() but its caps say otherwise");
  assert_int_equal(backend_registered([](rc_backend& b) { b.norm = any_norm; }), RC_ERR_PLUGIN);
  assert_message_has("has norm() but its caps say otherwise");
}

rc_status no_step(const rc_host*, const rc_problem*, const rc_options*, double*, double*) { return RC_STOP_STALLED; }

// Rows are for solvers that are built into the library.
void a_solver_that_takes_rows_is_refused(void**) {
  static rc_solver solver = {.struct_size = sizeof(rc_solver),
                             .name = "by-rows",
                             .summary = "a test's",
                             .license = "BSD-3-Clause",
                             .controls = RC_CONTROL_APPROACH,
                             .solve = no_step};
  static const rc_solver* const list[] = {&solver};
  const auto change = [](rc_plugin& plugin) {
    plugin.n_solvers = 1;
    plugin.solvers = list;
  };
  assert_int_equal(registered(change), RC_OK);
  solver.needs = RC_TAKES_ROWS;
  assert_int_equal(registered(change), RC_ERR_PLUGIN);
  assert_message_has("solver \"by-rows\" takes rows, which only solvers built into the library can");
}

// A backend that goes wrong once it is in use.
rc_status failing_create(const rc_host* host, const rc_operator_spec*, void**) {
  return host->fail(host, RC_ERR_MEMORY, "no room on the device");
}
rc_status silent_failure(void*, const rc_domain*) { return RC_ERR_INTERNAL; }

template <class Change> void assert_solve_gives(rc_status expected, const char* message, const Change& change) {
  static rc_backend backend;
  static const rc_backend* const list[] = {&backend};
  backend = *linked().backends[0];
  change(backend);
  rc_plugin plugin = linked();
  plugin.n_backends = 1;
  plugin.backends = list;
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  assert_int_equal(rc_context_register(registry.get(), &plugin), RC_OK);
  rc_options* options = nullptr;
  assert_int_equal(rc_options_create(registry.get(), &options), RC_OK);
  assert_int_equal(rc_options_set_text(options, RC_OPT_BACKEND, "linked"), RC_OK);
  rc_system system = support::unit_system();
  system.nx = 2;
  rc_contact* contact = nullptr;
  assert_int_equal(rc_contact_create(&system, options, &contact), RC_OK);
  const double gap[] = {0, 0.1};
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_APPROACH;
  step.undeformed_gap.data = gap;
  step.target = 1;
  // Twice: a failed step must leave the contact usable.
  for (int attempt = 0; attempt < 2; ++attempt) {
    rc_result result = RC_RESULT_INIT;
    double deformed[2];
    result.gap.data = deformed;  // takes the product over all points
    assert_int_equal(rc_contact_solve(contact, &step, &result), expected);
    assert_message_has(message);
  }
  rc_contact_destroy(contact);
  rc_options_destroy(options);
}

void failures_of_a_backend_in_use_are_passed_on(void**) {
  assert_solve_gives(RC_ERR_MEMORY, "rc_contact_solve: no room on the device", [](rc_backend& b) { b.create = failing_create; });
  assert_solve_gives(RC_ERR_INTERNAL, "binding the trial set failed with RC_ERR_INTERNAL",
                     [](rc_backend& b) { b.bind = silent_failure; });
}

void products_that_are_not_finite_are_not_an_answer(void**) {
  assert_solve_gives(RC_ERR_NUMERIC, "rc_contact_solve: ", [](rc_backend& b) {
    b.apply = b.field = [](void*, const double*, double* y) {
      y[0] = y[1] = __builtin_nan("");
      return rc_status{RC_OK};
    };
  });
}

void a_product_that_is_wrong_is_uncertified(void**) {
  assert_solve_gives(RC_UNCERTIFIED, "the solver claimed success, the library's own check disagrees", [](rc_backend& b) {
    b.field = [](void*, const double* x, double* y) {
      y[0] = 2 * x[0];
      y[1] = 2 * x[1];
      return rc_status{RC_OK};
    };
  });
}

}  // namespace

const std::vector<CMUnitTest> registration_tests = {
    cmocka_unit_test(a_linked_plugin_is_registered_and_solves),
    cmocka_unit_test(the_same_plugin_is_registered_only_once),
    cmocka_unit_test(contexts_do_not_share_what_is_registered),
    cmocka_unit_test(spoilt_descriptions_are_refused),
    cmocka_unit_test(spoilt_backends_are_refused),
    cmocka_unit_test(new_operations_and_their_bits_go_together),
    cmocka_unit_test(a_solver_that_takes_rows_is_refused),
    cmocka_unit_test(failures_of_a_backend_in_use_are_passed_on),
    cmocka_unit_test(products_that_are_not_finite_are_not_an_answer),
    cmocka_unit_test(a_product_that_is_wrong_is_uncertified),
};

}  // namespace plugins
