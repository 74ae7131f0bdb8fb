// The tests that every backend must pass. Each takes a backend and fails by cmocka's assertions.
#pragma once

#include <roughcontact/plugin.h>

namespace contract {

struct Case {
  const char* name;
  bool (*applies)(const rc_backend&);
  void (*run)(const rc_backend&);
};

inline bool always(const rc_backend&) { return true; }
inline bool takes_free(const rc_backend& backend) { return backend.caps & RC_CAP_FREE; }

void caps_agree_with_functions(const rc_backend&);

// products.cpp
void products_agree_with_the_matrix(const rc_backend&);
void rebinding_equals_a_fresh_operator(const rc_backend&);
void nan_is_not_hidden(const rc_backend&);
void every_choice_of_an_option_gives_the_same_product(const rc_backend&);

// forgetting.cpp
void forgetting_equals_a_fresh_operator(const rc_backend&);

// floats.cpp
void float_products_agree_with_double_ones(const rc_backend&);
void float_products_keep_their_accuracy_at_any_scale(const rc_backend&);
void either_precision_may_come_first(const rc_backend&);
void products_leave_alone_what_memory_holds_by_chance(const rc_backend&);

// threads.cpp
void results_do_not_depend_on_threads(const rc_backend&);
void operators_work_side_by_side(const rc_backend&);

// subsets.cpp
void subset_solves_its_equations(const rc_backend&);
void subset_after_changes_equals_a_fresh_solve(const rc_backend&);
void matrices_that_are_not_definite_are_reported(const rc_backend&);

// shifted.cpp
void shifted_solves_its_equations(const rc_backend&);
void shifted_does_not_depend_on_what_was_asked_before(const rc_backend&);
void norm_is_that_of_the_matrix(const rc_backend&);

// failures.cpp
void host_failure_is_passed_on(const rc_backend&);

// allocations.cpp
void any_allocation_may_fail(const rc_backend&);
void impossible_sizes_are_refused(const rc_backend&);

}  // namespace contract
