// A grid that is halved several times without the grids between, against one halving after the other: the same bits.
#include <random>
#include <vector>

#include "grid/downsample.h"
#include "support/cmocka.hpp"

namespace {

using namespace rc;

const EachRow backwards = [](std::int64_t rows, const std::function<void(std::int64_t)>& act) {
  while (rows-- > 0) act(rows);
};

void compare(std::int64_t nx, std::int64_t ny, double masked, int halvings, bool single) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> heights(0, 1);
  std::bernoulli_distribution leaves_out(masked);
  std::vector<float> values(static_cast<std::size_t>(nx * ny));
  std::vector<std::uint8_t> mask(masked > 0 ? values.size() : 0);
  for (float& value : values) value = heights(random);
  for (std::uint8_t& each : mask) each = leaves_out(random) ? 0 : 1;
  const std::vector<double> wide(values.begin(), values.end());
  const CoarseGrid found =
      downsample(nx, ny, single ? GapValues(std::span<const float>(values)) : GapValues(wide), mask, halvings, backwards);
  CoarseGrid expected{nx, ny, wide, mask};
  for (int k = 0; k < halvings; ++k) expected = downsample(expected.nx, expected.ny, expected.gap, expected.mask, Filter::mean);
  assert_int_equal(found.nx, expected.nx);
  assert_int_equal(found.ny, expected.ny);
  assert_true(found.gap == expected.gap);
  assert_true(found.mask == expected.mask);
}

void several_halvings_are_one_after_the_other(void**) {
  for (const int halvings : {1, 2, 3, 5})
    for (const double masked : {0.0, 0.3, 0.95})
      for (const bool single : {false, true}) {
        compare(64, 32, masked, halvings, single);
        compare(37, 21, masked, halvings, single);
        compare(1, 9, masked, halvings, single);
      }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(several_halvings_are_one_after_the_other)};
  return cmocka_run_group_tests_name("unit.downsample", tests, nullptr, nullptr);
}
