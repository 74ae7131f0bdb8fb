// The inverse that steps near each other keep only makes them faster: where there is no memory for it, they go on without. All
// other memory is needed.
#include <roughcontact/roughcontact.h>

#include <cmath>
#include <vector>

#include "support/cmocka.hpp"
#include "support/failing_new.h"
#include "support/unit_system.h"

namespace {

constexpr std::int64_t side = 20;
constexpr int steps_before = 13;           // the next one makes the inverse
constexpr int allocations_of_inverse = 6;  // at least

class Contact {
 public:
  Contact() : gap_(side * side), p(gap_.size()) {
    for (std::int64_t i = 0; i < side * side; ++i) {
      const double x = static_cast<double>(i % side) - 9.3, y = static_cast<double>(i / side) - 9.6;
      gap_[static_cast<std::size_t>(i)] = 0.01 * (x * x + y * y) + 0.1 * std::cos(2.1 * x) * std::cos(1.7 * y);
    }
    rc_system system = support::unit_system();
    system.nx = system.ny = side;
    rc_options* options = nullptr;
    assert_int_equal(rc_options_create(nullptr, &options), RC_OK);
    assert_int_equal(rc_options_set_text(options, RC_OPT_SOLVER, "haar-cg"), RC_OK);
    assert_int_equal(rc_options_set_text(options, RC_OPT_BACKEND, "dense"), RC_OK);
    assert_int_equal(rc_contact_create(&system, options, &contact_), RC_OK);
    rc_options_destroy(options);
  }
  ~Contact() { rc_contact_destroy(contact_); }
  Contact(const Contact&) = delete;
  Contact& operator=(const Contact&) = delete;

  rc_status step() {
    rc_step step = RC_STEP_INIT;
    step.control = RC_CONTROL_APPROACH;
    step.target = 0.6 * (1 + 5e-3 * (3 * (steps_++ + 3) % 7));
    step.undeformed_gap.data = gap_.data();
    rc_result result = RC_RESULT_INIT;
    result.p.data = p.data();
    const rc_status status = rc_contact_solve(contact_, &step, &result);
    products = result.products;
    return status;
  }

 private:
  std::vector<double> gap_;
  rc_contact* contact_ = nullptr;
  int steps_ = 0;

 public:
  std::vector<double> p;
  std::int64_t products = 0;
};

void steps_go_on_without_memory_for_the_inverse(void**) {
  Contact healthy;
  for (int k = 0; k <= steps_before; ++k) assert_int_equal(healthy.step(), RC_OK);
  int without = 0, refused = 0;
  bool reached = true;
  for (std::int64_t k = 1; reached; ++k) {
    Contact contact;
    for (int i = 0; i < steps_before; ++i) assert_int_equal(contact.step(), RC_OK);
    support::fail_allocation(k);
    const rc_status status = contact.step();
    reached = support::allocation_failed();
    support::fail_allocation(0);
    if (status != RC_OK) {
      assert_int_equal(status, RC_ERR_MEMORY);
      ++refused;
    } else {
      without += reached && contact.products > healthy.products;
      for (std::size_t i = 0; i < contact.p.size(); ++i) assert_true(std::abs(contact.p[i] - healthy.p[i]) <= 1e-5);
    }
    assert_int_equal(contact.step(), RC_OK);
  }
  print_message("%d steps without the inverse, %d refused\n", without, refused);
  assert_true(without >= allocations_of_inverse);
  assert_true(refused > 0);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(steps_go_on_without_memory_for_the_inverse)};
  return cmocka_run_group_tests_name("faults.near_steps", tests, nullptr, nullptr);
}
