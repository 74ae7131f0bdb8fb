// Steps of a history on the host build of the plugin for devices.
#include <cstdio>

#include "scene.h"

namespace {

using namespace device;

void a_step_starts_from_the_pressures_of_the_one_before(void**) {
  constexpr std::int64_t n = 128;  // so large that a cold step starts on coarser grids
  const std::vector<double> gap = hills_of(n);
  std::vector<double> p(gap.size());
  Contact contact(1048576, n);
  rc_step step = cold_step();
  step.undeformed_gap = gap.data();
  rc_result cold = RC_RESULT_INIT, again = RC_RESULT_INIT;
  cold.p = again.p = p.data();
  assert_int_equal(contact.solve(step, cold), RC_OK);
  step.warm_start = 1;
  assert_int_equal(contact.solve(step, again), RC_OK);
  assert_true(2 * again.applications < cold.applications);
}

// Also where the contact that made them is gone.
void plans_and_memory_stay_from_step_to_step(void**) {
  Contact contact;
  rc_contact* other = nullptr;
  const rc_system system = grid_of(side);
  assert_int_equal(rc_contact_create(&system, contact.options(), &other), RC_OK);
  rc_step step = cold_step();
  step.undeformed_gap = hills().data();
  rc_result result = RC_RESULT_INIT;
  const auto calls_of = [&](rc_contact* on) {
    rc_cuda::host_faults() = {.fault = rc_cuda::Fault::once, .at = 0};
    assert_int_equal(rc_contact_solve(on, &step, &result), RC_OK);
    const std::int64_t calls = rc_cuda::host_faults().calls;
    rc_cuda::host_faults() = {};
    return calls;
  };
  const std::int64_t first = calls_of(other), second = calls_of(other);
  std::printf("%lld calls of the layer below, then %lld\n", static_cast<long long>(first), static_cast<long long>(second));
  assert_true(second + 10 < first);
  assert_int_equal(calls_of(contact.get()), second);
  rc_contact_destroy(other);
  step.target = 0.2;  // a smaller box: plans of other lengths
  calls_of(contact.get());
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(a_step_starts_from_the_pressures_of_the_one_before),
                              cmocka_unit_test(plans_and_memory_stay_from_step_to_step)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
