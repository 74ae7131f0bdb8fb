// Small parts of the interface: the three ranges of statuses, the undeformed gap of heights.
#include <roughcontact/roughcontact.h>

#include <array>
#include <cmath>
#include <string>

#include "support/cmocka.hpp"

namespace {

void each_status_is_in_one_range(void**) {
#define RC_STATUS(name, value, text)                                                      \
  assert_int_equal(RC_CERTIFIED(name) + RC_USABLE(name) + RC_FAILED(name), 1);            \
  assert_true(RC_CERTIFIED(name) ? name == 0 : RC_USABLE(name) ? name >= 100 : name < 0); \
  assert_int_equal(RC_FAILED(name), std::string(#name).starts_with("RC_ERR_"));
#include "core/status.def"
#undef RC_STATUS
}

constexpr double nan = NAN;

void the_highest_point_touches_first(void**) {
  const std::array<double, 4> z = {1, 3, -2, 2.5};
  std::array<double, 4> gap{};
  assert_int_equal(rc_gap_from_heights(4, RC_IN(z.data()), {}, RC_OUT(gap.data())), RC_OK);
  assert_true((gap == std::array<double, 4>{2, 0, 5, 0.5}));
}

void masked_points_and_nan_are_not_the_highest(void**) {
  std::array<double, 4> z = {1, 3, nan, 2.5};
  const std::array<std::uint8_t, 4> mask = {1, 0, 1, 1};
  assert_int_equal(rc_gap_from_heights(4, RC_IN(z.data()), RC_IN(mask.data()), RC_OUT(z.data())), RC_OK);  // in place
  assert_true(z[0] == 1.5 && z[1] == -0.5 && std::isnan(z[2]) && z[3] == 0);
}

void where_no_point_is_there_heights_count_from_zero(void**) {
  std::array<double, 2> z = {1, nan};
  const std::array<std::uint8_t, 2> mask = {0, 1};
  assert_int_equal(rc_gap_from_heights(2, RC_IN(z.data()), RC_IN(mask.data()), RC_OUT(z.data())), RC_OK);
  assert_true(z[0] == -1 && std::isnan(z[1]));
  assert_int_equal(rc_gap_from_heights(0, {}, {}, {}), RC_OK);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(each_status_is_in_one_range),
      cmocka_unit_test(the_highest_point_touches_first),
      cmocka_unit_test(masked_points_and_nan_are_not_the_highest),
      cmocka_unit_test(where_no_point_is_there_heights_count_from_zero),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
