// Flows that are known: plates, strips, a constriction, a checkerboard, symmetries.
#include <cmath>

#include "flows.h"
#include "support/cmocka.hpp"

using namespace flow_tests;

namespace {

constexpr double tiny = 1e-12;

void contains(const rc_flow_result& found, double expected, const char* what) {
  const double u = 4e-16 * expected;  // of the expected value itself
  if (!(found.lower <= expected + u && expected - u <= found.upper))
    fail_msg("%s: %.17g is not in %.17g .. %.17g", what, expected, found.lower, found.upper);
}

void parallel_plates_let_through_the_cube(void**) {
  Field plates = uniform(7, 5, 0.2);
  plates.hx = 2;
  plates.hy = 0.5;
  const double along_x = 0.008 * (5 * 0.5) / (7 * 2), along_y = 0.008 * (7 * 2) / (5 * 0.5);
  for (const std::int32_t sides : {RC_FLOW_CLOSED, RC_FLOW_PERIODIC}) {
    require_near(flow(plates, RC_FLOW_X, sides).flow, along_x, tiny, "along x");
    require_near(flow(plates, RC_FLOW_Y, sides).flow, along_y, tiny, "along y");
  }
  rc_flow_spec spec = spec_of(plates);
  spec.viscosity = 1e-3;
  spec.pressure_drop = 1e5;
  rc_flow_result result = RC_FLOW_RESULT_INIT;
  assert_int_equal(rc_flow_solve(&spec, &result), RC_OK);
  require_near(result.flow, along_x * 1e5 / 12e-3, tiny, "with a fluid");
}

void strips_add_in_parallel_and_in_series(void**) {
  Field across = uniform(6, 4, 0), along = uniform(6, 4, 0);
  const double heights[] = {0.3, 1, 0.05, 0.6, 0.2, 0.9};
  double parallel = 0, resistance = 0;
  for (std::int64_t y = 0; y < 4; ++y)
    for (std::int64_t x = 0; x < 6; ++x) {
      along.at(x, y) = heights[y];
      across.at(x, y) = heights[x];
    }
  for (int y = 0; y < 4; ++y) parallel += std::pow(heights[y], 3) / 6;
  for (int x = 0; x < 6; ++x) resistance += 1 / std::pow(heights[x], 3) / 4;
  const rc_flow_result in_parallel = flow(along), in_series = flow(across);
  contains(in_parallel, parallel, "parallel");
  contains(in_series, 1 / resistance, "series");
  require_near(in_series.flow, 1 / resistance, 1e-9, "series");
  require_near(in_series.constriction, 0.05, tiny, "constriction");
  assert_int_equal(in_series.constriction_x, 2);
}

void one_channel_with_one_constriction_is_a_sum_of_resistances(void**) {
  for (const double height : {0.01, 1e-6}) {  // conductances differ by 10^6, 10^18
    Field channel = uniform(5, 5, 0);
    const std::int64_t path[][2] = {{0, 1}, {1, 1}, {1, 2}, {1, 3}, {2, 3}, {3, 3}, {4, 3}};
    for (const auto& [x, y] : path) channel.at(x, y) = 1;
    channel.at(1, 3) = height;
    // Half a cell at each end of the path, and six edges between its cells.
    const double k = std::pow(height, 3), beside = 2 * k / (1 + k);
    const double resistance = 0.5 + 0.5 + 4 + 2 / beside;
    const rc_flow_result found = flow(channel);
    contains(found, 1 / resistance, "constriction");
    require_near(found.flow, 1 / resistance, 1e-9, "constriction");
    assert_true(found.constriction_x == 1 && found.constriction_y == 3);
    require_near(found.constriction, height, tiny, "height");
  }
}

// In the limit of fine cells a checkerboard of k and 1/k conducts 1 (duality; Keller 1964). The squares' corners converge slowly.
void a_checkerboard_of_inverse_parts_tends_to_one(void**) {
  double before = 0;
  for (const std::int64_t cells : {8, 16, 32, 64}) {
    Field board = uniform(2 * cells, 2 * cells, 0);
    const double k = 3;
    for (std::int64_t y = 0; y < board.ny; ++y)
      for (std::int64_t x = 0; x < board.nx; ++x) board.at(x, y) = std::cbrt((x / cells + y / cells) % 2 == 0 ? k : 1 / k);
    const rc_flow_factors found = factors(board);
    require_near(found.xx, found.yy, 1e-9, "isotropy");
    const double error = std::abs(found.xx - 1);
    if (before > 0) {
      const double order = std::log2(before / error);
      // Near a corner the pressure goes as r^a, a = (4/pi) atan(1/k), and the energy's error as h^(2a).
      require_near(order, 8 / 3.14159265358979 * std::atan(1 / k), 0.1, "order");
    }
    before = error;
  }
}

void a_closed_gap_has_no_flow_with_proof(void**) {
  Field wall = uniform(9, 6, 1);
  for (std::int64_t y = 0; y < wall.ny; ++y) wall.at(4, y) = 0;
  const rc_flow_result closed = flow(wall);
  assert_true(closed.upper == 0 && closed.lower == 0 && closed.flow == 0 && !closed.crosses && closed.constriction == 0);
  assert_true(flow(wall, RC_FLOW_Y).lower > 0);
  // Cells that touch at corners only do not conduct.
  Field diagonal = uniform(4, 4, 0);
  for (std::int64_t i = 0; i < 4; ++i) diagonal.at(i, i) = 1;
  assert_true(flow(diagonal).upper == 0);
  assert_true(flow(uniform(3, 1, 0)).upper == 0);
}

void the_potential_falls_from_inlet_to_outlet(void**) {
  Field plates = uniform(4, 3, 1);
  plates.at(1, 1) = 0;
  std::vector<double> potential(12, -7);
  rc_flow_spec spec = spec_of(plates, RC_FLOW_Y);
  spec.potential.data = potential.data();
  rc_flow_result result = RC_FLOW_RESULT_INIT;
  assert_int_equal(rc_flow_solve(&spec, &result), RC_OK);
  assert_true(std::isnan(potential[5]));
  for (std::size_t x = 0; x < 4; ++x) {
    assert_true(potential[x] < 1 && potential[8 + x] > 0 && potential[x] > potential[8 + x]);
    require_near(potential[x], 1 - potential[8 + x], 1e-12, "symmetry");
  }
}

void stripes_that_lean_couple_the_axes(void**) {
  // Diagonal stripes: the tensor has the axes of the stripes, so xx = yy and xy < 0 or > 0 with the sense of the lean.
  Field lean = uniform(12, 12, 0);
  for (std::int64_t y = 0; y < 12; ++y)
    for (std::int64_t x = 0; x < 12; ++x) lean.at(x, y) = (x + y) % 12 < 6 ? 1 : 0.3;
  const rc_flow_factors found = factors(lean);
  require_near(found.xx, found.yy, 1e-9, "symmetry");
  assert_true(found.xy_upper < 0 && found.xy * found.xy < found.xx * found.yy);
  Field mirrored = lean;
  for (std::int64_t y = 0; y < 12; ++y)
    for (std::int64_t x = 0; x < 12; ++x) mirrored.at(x, y) = lean.at(11 - x, y);
  require_near(factors(mirrored).xy, -found.xy, 1e-6, "mirror image");
  require_near(found.mean_gap, 0.65, tiny, "mean gap");
  // Open stripes between closed ones conduct along themselves only: determinant 0, a lower bound above 0.
  for (double& g : lean.g)
    if (g < 1) g = 0;
  const rc_flow_factors open = factors(lean, 1e-4);
  assert_true(open.xx_lower > 0 && open.status == RC_OK);
  require_near(open.xx * open.yy, open.xy * open.xy, 1e-6, "determinant");
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(parallel_plates_let_through_the_cube),
      cmocka_unit_test(strips_add_in_parallel_and_in_series),
      cmocka_unit_test(one_channel_with_one_constriction_is_a_sum_of_resistances),
      cmocka_unit_test(a_checkerboard_of_inverse_parts_tends_to_one),
      cmocka_unit_test(a_closed_gap_has_no_flow_with_proof),
      cmocka_unit_test(the_potential_falls_from_inlet_to_outlet),
      cmocka_unit_test(stripes_that_lean_couple_the_axes),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
