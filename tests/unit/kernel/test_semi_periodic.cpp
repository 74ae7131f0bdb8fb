// Coefficients of grids that repeat along one axis: waves, windows, axes, signs. Sums of images: tests/scenes/influence.cpp.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "kernel/kernel.h"
#include "kernel/semi_periodic.h"
#include "support/cmocka.hpp"
#include "support/unit_system.h"

namespace {

using Vector = std::vector<double>;
constexpr double pi = std::numbers::pi;

struct Size {
  std::int64_t nx, ny;
  double hx, hy;
};
constexpr Size sizes[] = {{8, 6, 1, 1},      {16, 40, 0.5, 2}, {40, 16, 2, 0.5}, {1, 9, 1, 1}, {9, 1, 1, 1}, {1, 3, 1, 10},
                          {3, 64, 0.3, 3.3}, {64, 5, 3, 0.3},  {7, 30, 1, 1},    {2, 2, 1, 1}, {1, 1, 1, 1}, {12, 12, 1, 100}};

rc_system grid(const Size& size, std::int32_t boundary = RC_BOUNDARY_PERIODIC_X) {
  rc_system system = support::unit_system();
  system.boundary = boundary;
  system.nx = size.nx;
  system.ny = size.ny;
  system.hx = size.hx;
  system.hy = size.hy;
  return system;
}

const rc::kernel::Kernel& love() { return *rc::kernel::find("love"); }
const rc::kernel::Kernel& spectral() { return *rc::kernel::find("spectral"); }

Vector table(const rc::kernel::Kernel& kernel, const rc_system& system) {
  Vector values(static_cast<std::size_t>(system.nx * system.ny));
  rc::kernel::semi_periodic_coefficients(kernel, system, {0, 0, system.nx, system.ny}, values.data());
  return values;
}

// Along x it is the wave's amplitude, across it the integral over all waves: 2/|q|.
void spectral_deflects_waves_exactly(void**) {
  const rc_system s = grid({16, 400, 1, 0.25});
  const Vector values = table(spectral(), s);
  for (std::int64_t k = 1; k <= s.nx / 2; ++k) {
    double sum = 0;
    for (std::int64_t iy = 0; iy < s.ny; ++iy)
      for (std::int64_t ix = 0; ix < s.nx; ++ix)
        sum += (iy == 0 ? 1 : 2) * values[static_cast<std::size_t>(iy * s.nx + ix)] *
               std::cos(2 * pi * static_cast<double>(k * ix) / static_cast<double>(s.nx));
    const double q = 2 * pi * static_cast<double>(k) / static_cast<double>(s.nx);
    if (std::abs(sum - 2 / q) > 1e-9 * 2 / q) fail_msg("wave %d: %.12g instead of %.12g", static_cast<int>(k), sum, 2 / q);
  }
}

void windows_and_axes_change_no_bit(void**) {
  for (const rc::kernel::Kernel* kernel : {&love(), &spectral()})
    for (const Size& size : {Size{24, 17, 1, 0.7}, Size{7, 30, 2, 1}}) {
      const rc_system s = grid(size), turned = grid({size.ny, size.nx, size.hy, size.hx}, RC_BOUNDARY_PERIODIC_Y);
      const Vector along_x = table(*kernel, s), along_y = table(*kernel, turned);
      for (std::int64_t iy = 0; iy < s.ny; ++iy)
        for (std::int64_t ix = 0; ix < s.nx; ++ix) {
          const double value = along_x[static_cast<std::size_t>(iy * s.nx + ix)];
          double alone;
          rc::kernel::semi_periodic_coefficients(*kernel, s, {ix, iy, 1, 1}, &alone);
          assert_true(alone == value);
          assert_true(along_y[static_cast<std::size_t>(ix * s.ny + iy)] == value);
          if (ix > 0) {
            const double mirrored = along_x[static_cast<std::size_t>(iy * s.nx + s.nx - ix)];
            assert_true(std::abs(mirrored - value) <= 1e-14 * along_x[0]);
          }
        }
    }
}

void coefficients_of_love_are_positive(void**) {
  for (const Size& size : sizes)
    for (const double value : table(love(), grid(size))) assert_true(value > 0);
}

}  // namespace

int main() {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(spectral_deflects_waves_exactly),
      cmocka_unit_test(windows_and_axes_change_no_bit),
      cmocka_unit_test(coefficients_of_love_are_positive),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
