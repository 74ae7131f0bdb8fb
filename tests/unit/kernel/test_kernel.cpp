// The influence coefficients: against tables of values, and by the properties that define them.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "kernel/kernel.h"
#include "kernel/kernels.h"
#include "support/cmocka.hpp"

namespace {

using rc::kernel::Boundary;
using rc::kernel::Kernel;

const Kernel& kernel(const std::string& name) {
  const Kernel* found = rc::kernel::find(name);
  if (!found) fail_msg("no kernel %s", name.c_str());
  return *found;
}

struct Table {
  std::int64_t mx, my;
  std::vector<double> value;
  double operator()(std::int64_t ix, std::int64_t iy) const { return value[static_cast<std::size_t>(iy * mx + ix)]; }
};

Table table(const Kernel& k, double hx, double hy, std::int64_t mx, std::int64_t my) {
  Table t{mx, my, std::vector<double>(static_cast<std::size_t>(mx * my))};
  rc::kernel::coefficients(k, hx, hy, mx, my, t.value.data());
  return t;
}

double coefficient(const Kernel& k, double hx, double hy, std::int64_t ix, std::int64_t iy) {
  double value;
  rc::kernel::window_coefficients(k, hx, hy, {ix, iy, 1, 1}, &value);
  return value;
}

std::vector<Kernel> kernels(Boundary boundary) {
  std::vector<Kernel> chosen;
  for (const Kernel& k : rc::kernel::all())
    if (k.boundary == boundary) chosen.push_back(k);
  return chosen;
}

void assert_close(double value, double expected, double tolerance, const std::string& what) {
  if (!(std::abs(value - expected) <= tolerance * std::abs(expected)))
    fail_msg("%s: %.17g, expected %.17g, relative error %.2e", what.c_str(), value, expected,
             std::abs(value - expected) / std::abs(expected));
}

std::string at(const Kernel& k, std::int64_t ix, std::int64_t iy) {
  return std::string(k.name) + " at (" + std::to_string(ix) + ", " + std::to_string(iy) + ")";
}

void registry_is_sorted_and_finds_every_kernel(void**) {
  const auto all = rc::kernel::all();
  assert_true(std::ranges::is_sorted(all, {}, [](const Kernel& k) { return std::string(k.name); }));
  for (const Kernel& k : all) assert_ptr_equal(rc::kernel::find(k.name), &k);
  assert_null(rc::kernel::find("Love"));
  assert_null(rc::kernel::find(""));
}

void reference_values_are_met_at_near_and_far_offsets(void**) {
  std::ifstream file(RC_KERNEL_REFERENCE);
  std::map<std::string, int> count;
  for (std::string line; std::getline(file, line);) {
    std::istringstream fields(line);
    std::string name;
    double hx, hy, value;
    std::int64_t ix, iy;
    if (line.starts_with('#') || !(fields >> name >> hx >> hy >> ix >> iy >> value)) continue;
    assert_close(coefficient(kernel(name), hx, hy, ix, iy), value, 1e-12, line);
    ++count[name];
  }
  for (const Kernel& k : kernels(Boundary::free)) assert_true(count[k.name] >= 40);
}

// The expansions that serve from some cells on, whose digits all count: coefficients are summed up to a product's last ones.
void far_coefficients_are_exact_to_round_off(void**) {
  std::ifstream file(RC_KERNEL_REFERENCE);
  int count = 0;
  for (std::string line; std::getline(file, line);) {
    std::istringstream fields(line);
    std::string name;
    double hx, hy, value;
    std::int64_t ix, iy;
    if (line.starts_with('#') || !(fields >> name >> hx >> hy >> ix >> iy >> value)) continue;
    if (std::hypot(static_cast<double>(ix) * hx, static_cast<double>(iy) * hy) < 10 * std::max(hx, hy)) continue;
    assert_close(coefficient(kernel(name), hx, hy, ix, iy), value, 1e-15, line);
    ++count;
  }
  assert_true(count >= 80);
}

void a_window_is_a_part_of_the_table(void**) {
  for (const Kernel& k : kernels(Boundary::free)) {
    const Table whole = table(k, 0.5, 0.5, 20, 12);
    std::vector<double> part(7 * 5);
    rc::kernel::window_coefficients(k, 0.5, 0.5, {3, 4, 7, 5}, part.data());
    for (std::int64_t iy = 0; iy < 5; ++iy)
      for (std::int64_t ix = 0; ix < 7; ++ix) assert_true(part[static_cast<std::size_t>(iy * 7 + ix)] == whole(3 + ix, 4 + iy));
    // A coefficient does not depend on those computed side by side with it.
    const Table wide = table(k, 0.5, 0.5, 150, 3);
    std::vector<double> tail(101);
    for (const std::int64_t first : {31, 32, 49}) {
      rc::kernel::window_coefficients(k, 0.5, 0.5, {first, 2, 101, 1}, tail.data());
      for (std::int64_t ix = 0; ix < 101; ++ix) assert_true(tail[static_cast<std::size_t>(ix)] == wide(first + ix, 2));
    }
  }
}

// Nine cells make one of three times the side, at every distance: the formulas of near, middle and far offsets fit together.
void a_cell_is_the_sum_of_its_nine_parts(void**) {
  constexpr std::int64_t n = 24;
  for (const double hy : {0.01, 0.37, 1.0, 30.0}) {
    for (const Kernel& k : {kernel("love"), kernel("galerkin")}) {
      const bool mean = std::string(k.name) == "galerkin";  // also over the nine parts of the receiving cell
      const int reach = mean ? 2 : 1;
      const Table fine = table(k, 1, hy, 3 * n, 3 * n), coarse = table(k, 3, 3 * hy, n, n);
      for (std::int64_t iy = 0; iy < n; ++iy)
        for (std::int64_t ix = 0; ix < n; ++ix) {
          if (3 * std::max(ix, iy) + reach >= 3 * n) continue;
          double sum = 0;
          for (int dy = -reach; dy <= reach; ++dy)
            for (int dx = -reach; dx <= reach; ++dx) {
              const double weight = mean ? (3 - std::abs(dx)) * (3 - std::abs(dy)) / 9.0 : 1.0;
              sum += weight * fine(std::abs(3 * ix + dx), std::abs(3 * iy + dy));
            }
          assert_close(coarse(ix, iy), sum, 5e-13, at(k, ix, iy));
        }
    }
  }
}

void coefficients_are_positive_and_decay(void**) {
  constexpr std::int64_t n = 96;
  for (const Kernel& k : kernels(Boundary::free))
    for (const double hy : {1.0, 0.01, 100.0}) {
      if (k.square_cells && hy != 1) continue;
      const Table t = table(k, 1, hy, n, n);
      for (std::int64_t i = 0; i < n; ++i)
        for (std::int64_t j = 0; j < n; ++j) {
          assert_true(t(j, i) > 0);
          if (j > 0) assert_true(t(j, i) < t(j - 1, i) && t(i, j) < t(i, j - 1));
        }
    }
}

void a_kernel_has_no_coefficients_on_the_other_boundary(void**) {
  for (const Kernel& k : kernels(Boundary::periodic))
    for (const double value : table(k, 1, 1, 3, 2).value) assert_true(std::isnan(value));
}

struct Grid {
  std::int64_t nx, ny;
};
constexpr std::array<Grid, 9> grids{{{1, 1}, {1, 6}, {7, 1}, {2, 2}, {8, 8}, {9, 5}, {6, 11}, {16, 3}, {130, 4}}};

void symbol_is_two_over_the_wave_number(void**) {
  const double hx = 0.7, hy = 1.3;
  for (const Kernel& k : kernels(Boundary::periodic))
    for (const auto& [nx, ny] : grids) {
      Table t{nx / 2 + 1, ny / 2 + 1, std::vector<double>(static_cast<std::size_t>((nx / 2 + 1) * (ny / 2 + 1)))};
      rc::kernel::symbol(k, hx, hy, nx, ny, t.value.data());
      assert_true(t(0, 0) == 0);
      for (std::int64_t ky = 0; ky < t.my; ++ky)
        for (std::int64_t kx = 0; kx < t.mx; ++kx) {
          if (kx == 0 && ky == 0) continue;
          const double qx = 2 * std::numbers::pi * static_cast<double>(kx) / (static_cast<double>(nx) * hx);
          const double qy = 2 * std::numbers::pi * static_cast<double>(ky) / (static_cast<double>(ny) * hy);
          assert_close(t(kx, ky), 2 / std::hypot(qx, qy), 1e-14, at(k, kx, ky));
        }
    }
}

void periodic_coefficients_transform_to_the_symbol(void**) {
  const double hx = 0.7, hy = 1.3;
  for (const Kernel& k : kernels(Boundary::periodic))
    for (const auto& [nx, ny] : grids) {
      Table c{nx, ny, std::vector<double>(static_cast<std::size_t>(nx * ny))};
      rc::kernel::periodic_coefficients(k, hx, hy, nx, ny, nx, ny, c.value.data());
      std::vector<double> symbol(static_cast<std::size_t>((nx / 2 + 1) * (ny / 2 + 1)));
      rc::kernel::symbol(k, hx, hy, nx, ny, symbol.data());

      double magnitude = 0;
      for (const double value : c.value) magnitude += std::abs(value);
      for (std::int64_t ky = 0; ky < ny; ++ky)
        for (std::int64_t kx = 0; kx < nx; ++kx) {
          double real = 0, imaginary = 0;
          for (std::int64_t iy = 0; iy < ny; ++iy)
            for (std::int64_t ix = 0; ix < nx; ++ix) {
              const double turn = static_cast<double>(kx * ix % nx) / static_cast<double>(nx) +
                                  static_cast<double>(ky * iy % ny) / static_cast<double>(ny);
              real += c(ix, iy) * std::cos(2 * std::numbers::pi * turn);
              imaginary += c(ix, iy) * std::sin(2 * std::numbers::pi * turn);
            }
          const std::int64_t row = std::min(ky, ny - ky), column = std::min(kx, nx - kx);
          const double expected = symbol[static_cast<std::size_t>(row * (nx / 2 + 1) + column)];
          if (!(std::abs(real - expected) <= 1e-14 * magnitude && std::abs(imaginary) <= 1e-14 * magnitude))
            fail_msg("wave (%d, %d) of %d x %d: %.17g %+.2ei, expected %.17g", static_cast<int>(kx), static_cast<int>(ky),
                     static_cast<int>(nx), static_cast<int>(ny), real, imaginary, expected);
        }
    }
}

void a_corner_of_the_periodic_table_is_the_same(void**) {
  for (const Kernel& k : kernels(Boundary::periodic)) {
    Table whole{12, 9, std::vector<double>(12 * 9)};
    rc::kernel::periodic_coefficients(k, 1, 2, 12, 9, 12, 9, whole.value.data());
    for (const auto& [mx, my] : {Grid{1, 1}, {3, 9}, {12, 2}, {5, 4}}) {
      Table corner{mx, my, std::vector<double>(static_cast<std::size_t>(mx * my))};
      rc::kernel::periodic_coefficients(k, 1, 2, 12, 9, mx, my, corner.value.data());
      for (std::int64_t iy = 0; iy < my; ++iy)
        for (std::int64_t ix = 0; ix < mx; ++ix) assert_true(std::abs(corner(ix, iy) - whole(ix, iy)) <= 1e-14 * whole(0, 0));
    }
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(registry_is_sorted_and_finds_every_kernel),
      cmocka_unit_test(reference_values_are_met_at_near_and_far_offsets),
      cmocka_unit_test(far_coefficients_are_exact_to_round_off),
      cmocka_unit_test(a_window_is_a_part_of_the_table),
      cmocka_unit_test(a_cell_is_the_sum_of_its_nine_parts),
      cmocka_unit_test(coefficients_are_positive_and_decay),
      cmocka_unit_test(a_kernel_has_no_coefficients_on_the_other_boundary),
      cmocka_unit_test(symbol_is_two_over_the_wave_number),
      cmocka_unit_test(periodic_coefficients_transform_to_the_symbol),
      cmocka_unit_test(a_corner_of_the_periodic_table_is_the_same),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
