// Pressures in single precision in the memory of those in double: every value comes back, whatever their number, and the cap
// exactly.
#include <algorithm>
#include <vector>

#include "core/thread_team.h"
#include "solvers/haar_cg/single_pressures.h"
#include "support/cmocka.hpp"

namespace {

constexpr double cap = 200.1;  // no float

void values_come_back_and_the_room_is_free(void**) {
  const rc::ThreadTeam team(3);
  for (const std::size_t n : {0, 1, 2, 3, 7, 8, 9, 1000, 65536, 300001}) {
    std::vector<double> p;
    for (std::size_t i = 0; i < n; ++i) p.push_back(0.1 + static_cast<double>(i % 977) / 3);
    const std::vector<double> given = p;
    {
      const rc::SinglePressures single(p, cap, team);
      std::fill_n(single.room(), n, -1.0F);
      for (std::size_t i = 0; i < n; ++i) {
        assert_true(single.values()[i] == static_cast<float>(given[i]));
        single.values()[i] += 1;
      }
    }
    for (std::size_t i = 0; i < n; ++i) {
      const float value = static_cast<float>(given[i]) + 1;
      assert_true(p[i] == (value >= static_cast<float>(cap) ? cap : static_cast<double>(value)));
    }
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(values_come_back_and_the_room_is_free)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
