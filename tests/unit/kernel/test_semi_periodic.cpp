// Coefficients of grids that repeat along one axis: against sums of images, and waves.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "kernel/kernel.h"
#include "kernel/semi_periodic.h"
#include "support/cmocka.hpp"
#include "support/unit_system.h"

namespace {

using rc::kernel::Strip;
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

double at(const rc_system& s, std::int64_t ix, std::int64_t iy) {
  double value;
  rc::kernel::window_coefficients(love(), s.hx, s.hy, {std::abs(ix), iy, 1, 1}, &value);
  return value;
}

// M images on either side one by one, those beyond as an integral, to the second order in 1/M.
double images(const rc_system& s, std::int64_t ix, std::int64_t iy) {
  const auto M = std::max<std::int64_t>(
      100, static_cast<std::int64_t>(100 * static_cast<double>(s.ny) * s.hy / (static_cast<double>(s.nx) * s.hx)));
  const Strip strip = rc::kernel::strip_of(s);
  const double L = strip.period(), x = static_cast<double>(ix) * s.hx, y = static_cast<double>(iy) * s.hy;
  double sum = 0;
  for (std::int64_t m = M; m > 0; --m) sum += at(s, ix + m * s.nx, iy) + at(s, ix - m * s.nx, iy);
  sum += at(s, ix, iy);
  double beyond = 2 / L * std::log(strip.datum());
  for (const double from : {(static_cast<double>(M) + 0.5) * L + x, (static_cast<double>(M) + 0.5) * L - x}) {
    const double r = std::hypot(from, y);
    beyond -= std::log(from + r) / L + L * from / (24 * r * r * r);          // the sum by its integral
    beyond += (2 * s.hx * s.hx - s.hy * s.hy) / (24 * L * 2 * from * from);  // the mean over the cell
  }
  return sum + s.hx * s.hy / pi * beyond;
}

void coefficients_are_sums_of_images(void**) {
  for (const Size& size : sizes) {
    const rc_system s = grid(size);
    const Vector values = table(love(), s);
    for (std::int64_t iy = 0; iy < s.ny; iy += 1 + s.ny / 7)
      for (std::int64_t ix = 0; ix <= s.nx / 2; ix += 1 + s.nx / 9) {
        const double value = values[static_cast<std::size_t>(iy * s.nx + ix)], expected = images(s, ix, iy);
        if (std::abs(value - expected) > 1e-10 * values[0])
          fail_msg("%dx%d cells %g x %g at (%d, %d): %.15g instead of %.15g", static_cast<int>(s.nx), static_cast<int>(s.ny),
                   s.hx, s.hy, static_cast<int>(ix), static_cast<int>(iy), value, expected);
      }
  }
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
      cmocka_unit_test(coefficients_are_sums_of_images),
      cmocka_unit_test(spectral_deflects_waves_exactly),
      cmocka_unit_test(windows_and_axes_change_no_bit),
      cmocka_unit_test(coefficients_of_love_are_positive),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
