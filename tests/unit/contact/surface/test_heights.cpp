// Slopes of the heights that a step reads, against plain sums over the included points. Moments: tests/mutants.
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "contact/surface/rms_slope.h"
#include "contact/surface/step_surface.h"
#include "core/thread_team.h"
#include "support/cmocka.hpp"

namespace {

using namespace rc;

constexpr std::int64_t nx = 37, ny = 29;
constexpr double hx = 0.5, hy = 2;

struct Heights {
  explicit Heights(bool masked) {
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> number(0, 1);
    for (std::int64_t i = 0; i < nx * ny; ++i) {
      gap.push_back(number(generator) + 0.1 * static_cast<double>(i / nx));
      if (masked) mask.push_back(number(generator) < 0.8);
    }
  }
  bool included(std::int64_t i) const { return mask.empty() || mask[static_cast<std::size_t>(i)] != 0; }
  double at(std::int64_t i) const { return gap[static_cast<std::size_t>(i)]; }

  std::vector<double> gap;
  std::vector<std::uint8_t> mask;
};

void slopes_are_those_of_neighbours(void**) {
  const ThreadTeam team(2);
  for (const bool masked : {false, true}) {
    const Heights given(masked);
    const StepSurface surface({nx, ny, given.gap, given.mask, false}, team);
    double sum = 0, n = 0;
    const auto add = [&](std::int64_t i, std::int64_t j, double pitch) {
      if (given.included(i) && given.included(j)) sum += std::pow((given.at(j) - given.at(i)) / pitch, 2), ++n;
    };
    for (std::int64_t y = 0; y < ny; ++y)
      for (std::int64_t x = 0; x < nx; ++x) {
        if (x + 1 < nx) add(y * nx + x, y * nx + x + 1, hx);
        if (y + 1 < ny) add(y * nx + x, (y + 1) * nx + x, hy);
      }
    const double expected = std::sqrt(2 * sum / n);
    assert_true(std::abs(rms_slope(surface, hx, hy) - expected) <= 1e-12 * expected);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(slopes_are_those_of_neighbours),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
