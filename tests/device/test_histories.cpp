// Steps of a history on the host build of the plugin for devices.
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

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(a_step_starts_from_the_pressures_of_the_one_before)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
