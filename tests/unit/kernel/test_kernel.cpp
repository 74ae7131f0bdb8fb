// The influence coefficients against a table of values, and their windows. Products with them, free and periodic: tests/scenes.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
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

void registry_is_sorted_and_finds_every_kernel(void**) {
  const auto all = rc::kernel::all();
  assert_true(std::ranges::is_sorted(all, {}, [](const Kernel& k) { return std::string(k.name); }));
  for (const Kernel& k : all) assert_ptr_equal(rc::kernel::find(k.name), &k);
  assert_null(rc::kernel::find("Love"));
  assert_null(rc::kernel::find(""));
}

// Far offsets, where expansions serve, to round-off: their digits all count, because coefficients are summed up to a product's
// last ones.
void reference_values_are_met_at_near_and_far_offsets(void**) {
  std::ifstream file(RC_KERNEL_REFERENCE);
  std::map<std::string, int> count;
  int far = 0;
  for (std::string line; std::getline(file, line);) {
    std::istringstream fields(line);
    std::string name;
    double hx, hy, value;
    std::int64_t ix, iy;
    if (line.starts_with('#') || !(fields >> name >> hx >> hy >> ix >> iy >> value)) continue;
    const bool is_far = std::hypot(static_cast<double>(ix) * hx, static_cast<double>(iy) * hy) >= 10 * std::max(hx, hy);
    assert_close(coefficient(kernel(name), hx, hy, ix, iy), value, is_far ? 1e-15 : 1e-12, line);
    ++count[name];
    far += is_far;
  }
  for (const Kernel& k : kernels(Boundary::free)) assert_true(count[k.name] >= 40);
  assert_true(far >= 80);
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

void a_kernel_has_no_coefficients_on_the_other_boundary(void**) {
  for (const Kernel& k : kernels(Boundary::periodic))
    for (const double value : table(k, 1, 1, 3, 2).value) assert_true(std::isnan(value));
}

struct Grid {
  std::int64_t nx, ny;
};
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
      cmocka_unit_test(a_window_is_a_part_of_the_table),
      cmocka_unit_test(a_kernel_has_no_coefficients_on_the_other_boundary),
      cmocka_unit_test(a_corner_of_the_periodic_table_is_the_same),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
