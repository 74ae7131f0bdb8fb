// The cells of coarser grids: sides that are odd, points that are masked, several halvings at once.
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "contact/coarse/level.h"
#include "support/cmocka.hpp"

namespace {

constexpr std::int64_t nx = 5, ny = 3;

rc_system system_of_cells() {
  rc_system system = RC_SYSTEM_INIT;
  system.nx = nx;
  system.ny = ny;
  system.hx = 0.5;
  system.hy = 0.25;
  system.modulus = 2;
  system.boundary = RC_BOUNDARY_FREE;
  return system;
}

rc_options default_options() {
  rc_options* made = nullptr;
  assert_int_equal(rc_options_create(nullptr, &made), RC_OK);
  const rc_options options = *made;
  rc_options_destroy(made);
  return options;
}

// Gaps 0 .. 14, row by row.
struct Given {
  explicit Given(std::vector<std::uint8_t> points = {}) : mask(std::move(points)) {
    for (std::size_t i = 0; i < gap.size(); ++i) gap[i] = static_cast<double>(i);
    problem.surface = rc::StepSurface({nx, ny, gap, mask}, problem.team());
  }

  std::vector<double> gap = std::vector<double>(nx * ny);
  std::vector<std::uint8_t> mask;
  rc_options options = default_options();
  rc::GridProblem problem{system_of_cells(), options, nullptr};
};

void expect_gaps(const rc::Level& level, const std::vector<double>& expected) {
  const rc::GapValues& gap = level.problem().surface.gap();
  assert_int_equal(gap.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    assert_true(level.problem().surface.included(i) == !std::isnan(expected[i]));
    if (!std::isnan(expected[i])) assert_true(gap[i] == expected[i]);
  }
}

void the_last_cells_of_odd_sides_are_smaller(void**) {
  const Given given;
  const rc::Level level(given.problem, given.options, 1);
  const rc_system& system = level.problem().system.given;
  assert_int_equal(system.nx, 3);
  assert_int_equal(system.ny, 2);
  assert_true(system.hx == 1);
  assert_true(system.hy == 0.5);
  assert_true(system.modulus == 2);
  expect_gaps(level, {3, 5, 6.5, 10.5, 12.5, 14});
}

void a_cell_is_the_mean_of_its_included_points(void**) {
  const Given given({0, 1, 0, 0, 1,  //
                     1, 1, 0, 0, 1,  //
                     1, 1, 1, 0, 0});
  expect_gaps(rc::Level(given.problem, given.options, 1), {4, std::nan(""), 6.5, 10.5, 12, std::nan("")});
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(the_last_cells_of_odd_sides_are_smaller),
      cmocka_unit_test(a_cell_is_the_mean_of_its_included_points),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
