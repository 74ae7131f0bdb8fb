// Coefficients of grids that repeat along one axis: windows and axes. Their values: tests/scenes/influence.cpp.
#include <cmath>
#include <vector>

#include "kernel/kernel.h"
#include "kernel/semi_periodic.h"
#include "support/cmocka.hpp"
#include "support/unit_system.h"

namespace {

using Vector = std::vector<double>;

struct Size {
  std::int64_t nx, ny;
  double hx, hy;
};

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

}  // namespace

int main() {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(windows_and_axes_change_no_bit),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
