// Area, perimeter and corrected area: drawn cells, and spheres whose contact area is known.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "maps.h"

namespace analysis {

namespace {

using namespace pairs;

constexpr double hx = 0.5, hy = 2;  // of what is drawn
constexpr double c = (std::numbers::pi - 1 + std::numbers::ln2) / 24;

void check_area(const Map& map, std::int64_t contacts, double perimeter, std::int64_t front) {
  const rc_area area = area_of(map);
  const auto cells = static_cast<double>(contacts);
  check_equal(area.contacts, contacts, "contacts");
  check_near(area.area, cells * map.cell(), 1e-14 * cells, "area");
  check_near(area.perimeter, perimeter, 1e-14 * perimeter, "perimeter");
  check_near(area.corrected_area, (cells - c * static_cast<double>(front)) * map.cell(), 1e-14 * cells, "corrected area");
}

void single_cell() {
  check_near(c, 0.118114, 1e-6, "(pi - 1 + ln 2)/24");
  check_area(drawn({"...", ".#.", "..."}), 1, 2 * (hx + hy), 4);
  // In a corner of a free grid two of the edges are no front; with periodic boundaries all are.
  check_area(drawn({"#..", "...", "..."}), 1, 2 * (hx + hy), 2);
  check_area(drawn({"#..", "...", "..."}, RC_BOUNDARY_PERIODIC), 1, 2 * (hx + hy), 4);
}

void squares_and_rings() {
  check_area(drawn({"......", ".###..", ".###..", "......"}), 6, 6 * hx + 4 * hy, 10);
  check_area(drawn({".......", ".#####.", ".#...#.", ".#...#.", ".#####.", "......."}), 14,
             2 * (5 * hx + 4 * hy) + 6 * hx + 4 * hy, 28);
}

void checkerboards() {
  // Every edge of the grid is one of the perimeter, and corrected the area is as small as it can be.
  check_area(drawn({"#.#.#.", ".#.#.#", "#.#.#.", ".#.#.#"}, RC_BOUNDARY_PERIODIC), 12, 24 * (hx + hy), 48);
}

void no_contact_and_full_contact() {
  check_area(drawn({"...", "..."}), 0, 0, 0);
  // A flat punch ends where its cells end: nothing to correct.
  check_area(drawn({"###", "###"}), 6, 2 * (3 * hx + 2 * hy), 0);
  check_area(drawn({"###", "###"}, RC_BOUNDARY_PERIODIC), 6, 0, 0);
}

void grids_of_one_and_two_cells() {
  check_area(drawn({"#"}), 1, 2 * (hx + hy), 0);
  check_area(drawn({"#"}, RC_BOUNDARY_PERIODIC), 1, 0, 0);
  // Two cells share two edges where the grid is periodic.
  check_area(drawn({"#."}, RC_BOUNDARY_PERIODIC), 1, 2 * hy, 2);
  check_area(drawn({"#."}), 1, 2 * (hx + hy), 1);
  check_area(drawn({"#", "."}, RC_BOUNDARY_PERIODIC), 1, 2 * hx, 2);
}

void masked_cells_border_without_front() {
  check_area(drawn({".....", ".#x#.", "....."}), 2, 4 * (hx + hy), 6);
  check_area(drawn({"###", "#x#", "###"}), 8, 8 * hx + 8 * hy, 0);
}

void contact_across_the_sides() {
  const Map inside = drawn({"....", ".##.", ".##.", "...."}, RC_BOUNDARY_PERIODIC);
  const Map across = drawn({"#..#", "....", "....", "#..#"}, RC_BOUNDARY_PERIODIC);
  const rc_area a = area_of(inside), b = area_of(across);
  check_near(b.perimeter, a.perimeter, 0, "perimeter");
  check_near(b.corrected_area, a.corrected_area, 0, "corrected area");
}

void axes_change_places() {
  std::mt19937_64 random(1);
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    const Map map = random_map(13, 8, boundary, 0.5, 0.1, random);
    const rc_area a = area_of(map), b = area_of(transposed(map));
    check_equal(b.contacts, a.contacts, "contacts");
    check_near(b.perimeter, a.perimeter, 1e-14 * a.perimeter, "perimeter");
    check_near(b.corrected_area, a.corrected_area, 1e-14 * a.area, "corrected area");
  }
}

void lengths_scale() {
  std::mt19937_64 random(2);
  Map map = random_map(9, 11, RC_BOUNDARY_FREE, 0.5, 0, random);
  const rc_area a = area_of(map);
  map.system.hx *= 8;
  map.system.hy *= 8;
  for (double& value : map.p) value *= 1e-200;
  const rc_area b = area_of(map);
  check_near(b.area, 64 * a.area, 0, "area");
  check_near(b.perimeter, 8 * a.perimeter, 0, "perimeter");
  check_near(b.corrected_area, 64 * a.corrected_area, 0, "corrected area");
}

// Dense and callback systems: a free grid, whatever stands in boundary.
void without_half_space_the_grid_is_free() {
  Map map = drawn({"#.#"});
  const rc_area free = area_of(map);
  map.system.boundary = RC_BOUNDARY_PERIODIC;
  for (const std::int32_t op : {RC_OPERATOR_DENSE, RC_OPERATOR_CALLBACK}) {
    map.system.op = op;
    check_near(area_of(map).perimeter, free.perimeter, 0, "perimeter");
  }
}

// Relative errors of the raw and the corrected area of a sphere's contact of radius `radius` in units of hx, its centre off that
// of a cell by (x, y) cells; pitch: hy / hx.
struct Errors {
  double raw, corrected;
};

Errors sphere_errors(double radius, double x, double y, double pitch) {
  constexpr double curvature = 1e-3;
  Problem problem;
  problem.system.nx = 2 * static_cast<std::int64_t>(1.5 * radius) + 1;
  problem.system.ny = 2 * static_cast<std::int64_t>(1.5 * radius / pitch) + 1;
  problem.system.hy = pitch;
  const auto offset = [](std::int64_t i, std::int64_t n, double shift) { return static_cast<double>(i - n / 2) - shift; };
  for (std::int64_t iy = 0; iy < problem.system.ny; ++iy)
    for (std::int64_t ix = 0; ix < problem.system.nx; ++ix)
      problem.gap.push_back(
          curvature / 2 *
          (std::pow(offset(ix, problem.system.nx, x), 2) + std::pow(pitch * offset(iy, problem.system.ny, y), 2)));
  problem.target = curvature * radius * radius;
  Map map;
  map.system = problem.system;
  map.p = solved(problem, automatic, {{RC_OPT_TOL, "1e-10"}}).p;
  const rc_area area = area_of(map);
  const double exact = std::numbers::pi * radius * radius;
  return {area.area / exact - 1, area.corrected_area / exact - 1};
}

void correction_helps_spheres() {
  for (const double pitch : {1.0, 1.6}) {
    double raw = 0, corrected = 0, worst = 0;
    int cases = 0, better = 0;
    for (const double radius : {5.0, 7.3, 9.6, 12.0, 16.4, 21.0})
      for (const double x : {0.0, 0.2, 0.5})
        for (const double y : {0.0, 0.35, 0.5}) {
          const Errors errors = sphere_errors(radius, x, y, pitch);
          raw += errors.raw;
          corrected += errors.corrected;
          worst = std::max(worst, std::abs(errors.corrected) * radius);
          better += std::abs(errors.corrected) < std::abs(errors.raw);
          ++cases;
        }
    report("hy / hx = " + text(pitch) + ": mean error raw " + text(raw / cases) + ", corrected " + text(corrected / cases) +
           ", better in " + std::to_string(better) + " of " + std::to_string(cases) + ", worst times radius " + text(worst));
    check(raw > 0, "the raw area is too large on average");
    check(std::abs(corrected) < 0.5 * raw, "the correction takes more than half of the mean error");
    check(10 * better >= 8 * cases, "the corrected area is closer in four of five cases");
  }
}

}  // namespace

std::vector<Test> area_tests() {
  return {{"single_cell_has_four_edges", single_cell},
          {"squares_and_rings_have_the_edges_that_are_drawn", squares_and_rings},
          {"checkerboard_is_the_lower_end_of_the_correction", checkerboards},
          {"no_contact_is_zero_and_a_flat_punch_is_not_corrected", no_contact_and_full_contact},
          {"grids_of_one_and_two_cells", grids_of_one_and_two_cells},
          {"masked_cells_border_without_front", masked_cells_border_without_front},
          {"contact_across_the_sides_is_as_inside", contact_across_the_sides},
          {"transposition_swaps_the_pitches", axes_change_places},
          {"lengths_scale_and_pressures_do_not_matter", lengths_scale},
          {"without_half_space_the_grid_is_free", without_half_space_the_grid_is_free},
          {"corrected_area_of_spheres_is_closer_to_hertz", correction_helps_spheres}};
}

}  // namespace analysis
