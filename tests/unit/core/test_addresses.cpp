// Sizes that are accepted can be counted by addresses, on 32-bit systems, too.
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/grid.h"
#include "platform/memory.h"
#include "support/cmocka.hpp"

namespace {

void complex_numbers_of_the_largest_padded_grid_are_addressable(void**) {
  constexpr std::int64_t bytes_a_point = 4 * 16;
  assert_true(rc::most_points <= std::numeric_limits<std::ptrdiff_t>::max() / bytes_a_point);
}

void no_more_memory_is_counted_on_than_addresses_reach(void**) {
  assert_true(rc_platform::machine_bytes() > 1048576);
  assert_true(rc_platform::machine_bytes() <= static_cast<double>(PTRDIFF_MAX));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(complex_numbers_of_the_largest_padded_grid_are_addressable),
                              cmocka_unit_test(no_more_memory_is_counted_on_than_addresses_reach)};
  return cmocka_run_group_tests_name("unit.addresses", tests, nullptr, nullptr);
}
