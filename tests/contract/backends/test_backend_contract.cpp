// Every backend through its vtable alone.
#include <roughcontact/plugin.h>

#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "cases.h"
#include "fixtures.h"
#include "support/cmocka.hpp"

// RC_CONTRACT_BACKENDS is a list of RC_CONTRACT_BACKEND(name).
#define RC_CONTRACT_BACKEND(name) extern "C" rc_status rc_builtin_##name(const rc_host*, const rc_plugin**);
RC_CONTRACT_BACKENDS
#undef RC_CONTRACT_BACKEND

namespace contract {

void caps_agree_with_functions(const rc_backend& backend) {
  assert_true(backend.struct_size == sizeof(rc_backend));
  assert_true(backend.create && backend.destroy && backend.bind && backend.apply && backend.field && backend.modelled);
  assert_true((backend.caps & RC_CAP_SUBSET) ? backend.subset != nullptr : backend.subset == nullptr);
  assert_true((backend.caps & RC_CAP_SHIFTED) ? backend.shifted != nullptr : backend.shifted == nullptr);
  assert_true((backend.caps & RC_CAP_NORM) ? backend.norm != nullptr : backend.norm == nullptr);
  assert_true((backend.caps & RC_CAP_FLOAT) ? backend.apply_float != nullptr : backend.apply_float == nullptr);
  assert_true((backend.caps & RC_CAP_SCREEN) ? backend.screen != nullptr : backend.screen == nullptr);
  assert_true(backend.caps & (RC_CAP_FREE | RC_CAP_PERIODIC | RC_CAP_DENSE_INPUT | RC_CAP_CALLBACK));
  assert_true(std::strlen(backend.summary) > 0 && std::strlen(backend.license) > 0);
  const std::string prefix = std::string(backend.name) + ".";
  for (std::int64_t i = 0; i < backend.n_options; ++i) {
    assert_true(backend.options[i]->struct_size == sizeof(rc_component));
    assert_true(std::string(backend.options[i]->name).find(prefix) == 0);
  }
}

namespace {

bool has_subset(const rc_backend& backend) { return backend.caps & RC_CAP_SUBSET; }
bool has_shifted(const rc_backend& backend) { return backend.caps & RC_CAP_SHIFTED; }
bool has_norm(const rc_backend& backend) { return backend.caps & RC_CAP_NORM; }
bool has_float(const rc_backend& backend) { return backend.caps & RC_CAP_FLOAT; }
bool can_forget(const rc_backend& backend) { return backend.forget != nullptr; }
bool claims_thread_invariance(const rc_backend& backend) { return backend.caps & RC_CAP_THREAD_INVARIANT; }

#define RC_CASE(function, applies) \
  Case { #function, applies, function }
const Case cases[] = {
    RC_CASE(caps_agree_with_functions, always),
    RC_CASE(products_agree_with_the_matrix, always),
    RC_CASE(rebinding_equals_a_fresh_operator, always),
    RC_CASE(forgetting_equals_a_fresh_operator, can_forget),
    RC_CASE(nan_is_not_hidden, takes_grids),
    RC_CASE(every_choice_of_an_option_gives_the_same_product, always),
    RC_CASE(float_products_agree_with_double_ones, has_float),
    RC_CASE(float_products_keep_their_accuracy_at_any_scale, has_float),
    RC_CASE(either_precision_may_come_first, has_float),
    RC_CASE(products_leave_alone_what_memory_holds_by_chance, has_float),
    RC_CASE(results_do_not_depend_on_threads, claims_thread_invariance),
    RC_CASE(operators_work_side_by_side, takes_grids),
    RC_CASE(subset_solves_its_equations, has_subset),
    RC_CASE(subset_after_changes_equals_a_fresh_solve, has_subset),
    RC_CASE(matrices_that_are_not_definite_are_reported, has_subset),
    RC_CASE(shifted_solves_its_equations, has_shifted),
    RC_CASE(shifted_does_not_depend_on_what_was_asked_before, has_shifted),
    RC_CASE(norm_is_that_of_the_matrix, has_norm),
    RC_CASE(host_failure_is_passed_on, takes_grids),
#ifdef RC_CONTRACT_FAILING_NEW
    RC_CASE(any_allocation_may_fail, takes_grids),
    RC_CASE(impossible_sizes_are_refused, takes_free),
#endif
};
#undef RC_CASE

struct Test {
  const rc_backend* backend;
  const Case* test_case;
  std::string name;
};

void run(void** state) {
  const Test& test = *static_cast<const Test*>(*state);
  test.test_case->run(*test.backend);
}

// only: a backend's name, or null.
std::vector<Test> all_tests(const char* only) {
  std::vector<Test> tests;
#define RC_CONTRACT_BACKEND(name) rc_builtin_##name,
  const rc_plugin_query_fn queries[] = {RC_CONTRACT_BACKENDS};
#undef RC_CONTRACT_BACKEND
  for (rc_plugin_query_fn query : queries) {
    const rc_plugin* plugin = nullptr;
    if (query(nullptr, &plugin) != RC_OK || plugin->abi_major != RC_PLUGIN_ABI_MAJOR) std::abort();
    for (std::int64_t i = 0; i < plugin->n_backends; ++i)
      for (const Case& test_case : cases)
        if (test_case.applies(*plugin->backends[i]) && (!only || std::string(only) == plugin->backends[i]->name))
          tests.push_back({plugin->backends[i], &test_case, std::string(plugin->backends[i]->name) + "/" + test_case.name});
  }
  return tests;
}

}  // namespace

}  // namespace contract

int main(int argc, char** argv) {
  std::vector<contract::Test> tests = contract::all_tests(argc > 1 ? argv[1] : nullptr);
  if (tests.empty()) return 1;
  std::vector<CMUnitTest> list;
  for (contract::Test& test : tests) list.push_back({test.name.c_str(), contract::run, nullptr, nullptr, &test});
  return _cmocka_run_group_tests("backends", list.data(), list.size(), nullptr, nullptr);
}
