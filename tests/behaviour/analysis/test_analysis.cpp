// Analyses of a contact: drawn maps, random ones against a flood fill, and closed forms.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "maps.h"

namespace analysis {

namespace {

using namespace pairs;

constexpr std::int32_t open = RC_BOUNDARY_FREE, periodic = RC_BOUNDARY_PERIODIC, periodic_x = RC_BOUNDARY_PERIODIC_X,
                       periodic_y = RC_BOUNDARY_PERIODIC_Y;
constexpr double hx = 0.5, hy = 2;  // of what is drawn
constexpr double c = (std::numbers::pi - 1 + std::numbers::ln2) / 24;

void check_area(const Map& map, std::int64_t contacts, double perimeter, std::int64_t front) {
  const rc_area area = area_of(map);
  const auto cells = static_cast<double>(contacts);
  check_equal(area.contacts, contacts, "contacts");
  check_near(area.area, cells * map.cell(), 1e-14 * cells, "area");
  check_near(area.perimeter, perimeter, 1e-13 * perimeter, "perimeter");
  check_near(area.corrected_area, (cells - c * static_cast<double>(front)) * map.cell(), 1e-13 * cells, "corrected area");
}

// The front are the edges between contact and gap; those of the grid and of masked cells are none.
void drawn_areas() {
  struct Drawn {
    std::vector<std::string> rows;
    std::int32_t boundary;
    std::int64_t contacts;
    double perimeter;
    std::int64_t front;
  };
  check_near(c, 0.118114, 1e-6, "(pi - 1 + ln 2)/24");
  for (const Drawn& each : {
           Drawn{{"...", ".#.", "..."}, open, 1, 2 * (hx + hy), 4},
           Drawn{{"#..", "...", "..."}, periodic, 1, 2 * (hx + hy), 4},
           Drawn{{"......", ".###..", ".###..", "......"}, open, 6, 6 * hx + 4 * hy, 10},
           Drawn{{".......", ".#####.", ".#...#.", ".#...#.", ".#####.", "......."}, open, 14, 16 * hx + 12 * hy, 28},
           Drawn{{"#.#.#.", ".#.#.#", "#.#.#.", ".#.#.#"}, periodic, 12, 24 * (hx + hy), 48},
           Drawn{{"###", "###"}, open, 6, 2 * (3 * hx + 2 * hy), 0},
           Drawn{{"###", "###"}, periodic, 6, 0, 0},
           Drawn{{"#"}, periodic, 1, 0, 0},
           Drawn{{"#."}, periodic, 1, 2 * hy, 2},
           Drawn{{".....", ".#x#.", "....."}, open, 2, 4 * (hx + hy), 6},
           Drawn{{"###", "#x#", "###"}, open, 8, 8 * hx + 8 * hy, 0},
       })
    check_area(drawn(each.rows, each.boundary), each.contacts, each.perimeter, each.front);
}

// Sums of RC_CROSSES_*.
struct Crossing {
  std::int32_t contact = -7, gap = -7;
};

Crossing crossing_of(const Map& map) {
  Crossing found;
  check(rc_crossing_find(&map.system, RC_IN(map.p.data()), RC_IN(map.mask_data()), &found.contact, &found.gap) == RC_OK,
        rc_last_error());
  return found;
}

// The inlet and the outlet of a seal stay apart; across the flow the surface repeats.
void drawn_crossings() {
  // A channel that leaves at the lower side and comes back at the upper one, and ends at another height than it began.
  const std::vector<std::string> wrapping{"#.##", "#.##", "..##", "####", "#..."},
      inverse{".#..", ".#..", "##..", "....", ".###"};
  struct Drawn {
    std::vector<std::string> rows;
    std::int32_t boundary;
    std::string contact, gap;
  };
  for (const Drawn& each :
       {Drawn{{"...", "###", "..."}, open, "x", "x"}, Drawn{{".#.", "###", ".#."}, open, "xy", ""},
        Drawn{{"###", "###"}, open, "xy", ""}, Drawn{{"#..", ".#.", "..#"}, open, "", ""},
        Drawn{{"#..", "...", "..#"}, periodic, "", "xy"}, Drawn{{"##..", ".##.", "..##", "#..#"}, periodic, "xy", "xy"},
        Drawn{wrapping, periodic, "xy", "x"}, Drawn{inverse, periodic_y, "x", "xy"}, Drawn{wrapping, open, "xy", ""},
        Drawn{inverse, periodic_x, "", "xy"}, Drawn{{"##x##", "##x##"}, open, "y", ""},
        Drawn{{"..x..", "..x.."}, open, "", "y"}}) {
    const auto sum = [](const std::string& axes) {
      return (axes.find('x') != axes.npos ? RC_CROSSES_X : 0) + (axes.find('y') != axes.npos ? RC_CROSSES_Y : 0);
    };
    const Crossing found = crossing_of(drawn(each.rows, each.boundary));
    check(found.contact == sum(each.contact), "the contact crosses along " + each.contact);
    check(found.gap == sum(each.gap), "the gap crosses along " + each.gap);
  }
}

void check_numbers(const std::vector<std::int64_t>& found, const std::vector<std::int64_t>& expected, const std::string& what) {
  check_equal(static_cast<std::int64_t>(found.size()), static_cast<std::int64_t>(expected.size()), what + ", length");
  for (std::size_t i = 0; i < found.size(); ++i) check_equal(found[i], expected[i], what + "[" + std::to_string(i) + "]");
}

void patches_have_their_numbers() {
  const Map map = drawn({"..3.7", "12..7", "....x", "5...."});
  const Patches found = patches_of(map, 4);
  check_equal(found.count, 4, "count");
  check_numbers(found.label, {-1, -1, 0, -1, 1, 2, 2, -1, -1, 1, -1, -1, -1, -1, -1, 3, -1, -1, -1, -1}, "label");
  check_numbers(found.cells, {1, 2, 2, 1}, "cells");
  check_numbers(found.peak, {2, 4, 6, 15}, "peak");
  check_near(found.area, {1, 2, 2, 1}, 0, "area");
  check_near(found.perimeter, {5, 9, 6, 5}, 0, "perimeter");
  check_near(found.load, {3, 14, 3, 5}, 0, "load");
  check_near(found.mean_pressure, {3, 7, 1.5, 5}, 0, "mean pressure");
  check_near(found.max_pressure, {3, 7, 2, 5}, 0, "largest pressure");
  // Across the corner the first and the third are one, and across the sides the second as well.
  check_numbers(patches_of(map, 8).cells, {3, 2, 1}, "cells, eight neighbours");
  const Patches joined = patches_of(drawn({"..3.7", "12..7", "....x", "5...."}, RC_BOUNDARY_PERIODIC), 4);
  check_numbers(joined.cells, {1, 4, 1}, "cells, periodic");
  check_near(joined.load, {3, 17, 5}, 0, "load, periodic");
}

void room_for_fewer_patches() {
  const Map map = drawn({"1.2.3"});
  Field load(3, -7);
  rc_patches patches = RC_PATCHES_INIT;
  patches.room = 2;
  patches.load = RC_OUT(load.data());
  check(rc_patches_find(&map.system, RC_IN(map.p.data()), {}, &patches) == RC_OK, rc_last_error());
  check_equal(patches.count, 3, "count");
  check_near(load, {1, 2, -7}, 0, "load");
  patches.room = 0;
  load.assign(3, -7);
  check(rc_patches_find(&map.system, RC_IN(map.p.data()), {}, &patches) == RC_OK, rc_last_error());
  check_equal(patches.count, 3, "count");
  check_near(load, {-7, -7, -7}, 0, "load");
}

// Cells and their neighbours, where these are in the grid.
class Grid {
 public:
  Grid(const Map& map, bool joins_x, bool joins_y)
      : nx_(map.system.nx), ny_(map.system.ny), joins_x_(joins_x), joins_y_(joins_y) {}
  explicit Grid(const Map& map) : Grid(map, joins(map, periodic_x), joins(map, periodic_y)) {}

  static bool joins(const Map& map, std::int32_t along) {
    return map.system.op == RC_OPERATOR_HALFSPACE && (map.system.boundary == periodic || map.system.boundary == along);
  }
  // Number k of left, right, below, above, and corners; -1: none.
  std::int64_t next(std::int64_t i, std::int32_t k) const {
    constexpr std::int64_t steps[8][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
    std::int64_t x = i % nx_ + steps[k][0], y = i / nx_ + steps[k][1];
    if (joins_x_) x = (x + nx_) % nx_;
    if (joins_y_) y = (y + ny_) % ny_;
    return x >= 0 && x < nx_ && y >= 0 && y < ny_ ? y * nx_ + x : -1;
  }
  // The part of each cell that is inside, numbered by its first one; -1 elsewhere.
  template <class Inside> std::vector<std::int64_t> flooded(std::int32_t neighbours, const Inside& inside) const {
    std::vector<std::int64_t> label(static_cast<std::size_t>(nx_ * ny_), -1), waiting;
    std::int64_t count = 0;
    for (std::int64_t start = 0; start < nx_ * ny_; ++start) {
      if (!inside(start) || label[static_cast<std::size_t>(start)] >= 0) continue;
      label[static_cast<std::size_t>(start)] = count;
      for (waiting.push_back(start); !waiting.empty();) {
        const std::int64_t i = waiting.back();
        waiting.pop_back();
        for (std::int32_t k = 0; k < neighbours; ++k) {
          const std::int64_t j = next(i, k);
          if (j < 0 || !inside(j) || label[static_cast<std::size_t>(j)] >= 0) continue;
          label[static_cast<std::size_t>(j)] = count;
          waiting.push_back(j);
        }
      }
      ++count;
    }
    return label;
  }

 private:
  std::int64_t nx_, ny_;
  bool joins_x_, joins_y_;
};

bool included(const Map& map, std::int64_t i) { return map.mask.empty() || map.mask[static_cast<std::size_t>(i)] != 0; }

void check_patches(const Map& map, std::int32_t neighbours) {
  const Grid grid(map);
  const Patches found = patches_of(map, neighbours);
  const std::vector<std::int64_t> label = grid.flooded(neighbours, [&](std::int64_t i) { return map.touches(i); });
  check_numbers(found.label, label, "label");
  const auto count = static_cast<std::size_t>(*std::ranges::max_element(label) + 1);
  std::vector<std::int64_t> cells(count);
  Field load(count), perimeter(count), most(count);
  std::int64_t contacts = 0, front = 0;
  for (std::size_t i = 0; i < label.size(); ++i) {
    if (label[i] < 0) continue;
    const auto k = static_cast<std::size_t>(label[i]);
    ++cells[k], ++contacts;
    load[k] += map.p[i] * map.cell();
    most[k] = std::max(most[k], map.p[i]);
    for (std::int32_t side = 0; side < 4; ++side) {
      const std::int64_t j = grid.next(static_cast<std::int64_t>(i), side);
      if (j >= 0 && map.touches(j)) continue;
      perimeter[k] += side < 2 ? map.system.hy : map.system.hx;
      front += j >= 0 && included(map, j);
    }
  }
  check_numbers(found.cells, cells, "cells");
  check_near(found.load, load, 1e-13, "load");
  check_near(found.perimeter, perimeter, 1e-13, "perimeter");
  check_near(found.max_pressure, most, 0, "largest pressure");
  for (std::size_t k = 0; k < count; ++k) {
    const auto peak = static_cast<std::size_t>(found.peak[k]);
    check_equal(label[peak], static_cast<std::int64_t>(k), "the peak's patch");
    check_near(map.p[peak], most[k], 0, "pressure at the peak");
    check_near(found.area[k], static_cast<double>(cells[k]) * map.cell(), 1e-13 * found.area[k], "area");
    check_near(found.mean_pressure[k], load[k] / found.area[k], 1e-13 * most[k], "mean pressure");
  }
  check_area(map, contacts, sum(perimeter), front);
}

// Axes along which cells inside reach from side to side, going on across the axis where the grid repeats.
template <class Inside> std::int32_t reaches(const Map& map, const Inside& inside) {
  std::int32_t axes = 0;
  const std::int64_t nx = map.system.nx, ny = map.system.ny;
  for (const bool along_x : {true, false}) {
    const Grid grid(map, !along_x && Grid::joins(map, periodic_x), along_x && Grid::joins(map, periodic_y));
    const std::vector<std::int64_t> label = grid.flooded(4, inside);
    const auto at = [&](std::int64_t x, std::int64_t y) { return label[static_cast<std::size_t>(y * nx + x)]; };
    for (std::int64_t a = 0; a < (along_x ? ny : nx); ++a)
      for (std::int64_t b = 0; b < (along_x ? ny : nx); ++b) {
        const std::int64_t first = along_x ? at(0, a) : at(a, 0), last = along_x ? at(nx - 1, b) : at(b, ny - 1);
        if (first >= 0 && first == last) axes |= along_x ? RC_CROSSES_X : RC_CROSSES_Y;
      }
  }
  return axes;
}

void check_histogram(const Map& map, double upper) {
  const Histogram found = histogram_of(map, 17, upper);
  const double end = upper > 0 ? upper : found.said.max_pressure, contacts = static_cast<double>(found.said.contacts);
  check_equal(std::accumulate(found.counts.begin(), found.counts.end(), found.said.above), found.said.contacts, "counts");
  for (std::size_t k = 0; k < 17; ++k) {
    const double low = static_cast<double>(k) * found.said.width,
                 high = k == 16 ? end : static_cast<double>(k + 1) * found.said.width;
    std::int64_t inside = 0;
    for (std::size_t i = 0; i < map.points(); ++i)
      inside += map.touches(static_cast<std::int64_t>(i)) && map.p[i] > low && map.p[i] <= high;
    check_equal(found.counts[k], inside, "points between the edges");
    if (inside > 0)
      check_near(found.density[k], static_cast<double>(inside) / contacts / found.said.width, 1e-13 * found.density[k],
                 "density");
  }
}

void random_maps_are_as_flooded() {
  std::mt19937_64 random(3);
  std::int64_t maps = 0, crossed[2] = {};
  for (const auto& [nx, ny] :
       {std::pair<std::int64_t, std::int64_t>{1, 1}, {1, 7}, {7, 1}, {2, 2}, {2, 5}, {3, 3}, {5, 5}, {9, 7}, {17, 23}, {40, 31}})
    for (const std::int32_t boundary : {open, periodic, periodic_x, periodic_y})
      for (const double share : {0.05, 0.3, 0.5, 0.65, 0.8, 1.0})
        for (const double masked : {0.0, 0.15})
          for (int repeat = 0; repeat < 4; ++repeat) {
            Map map = random_map(nx, ny, boundary, share, masked, random);
            if (repeat == 3) map.system.op = RC_OPERATOR_DENSE;  // a free grid, whatever stands in boundary
            check_patches(map, 4);
            check_patches(map, 8);
            const Crossing found = crossing_of(map);
            check_equal(found.contact, reaches(map, [&](std::int64_t i) { return map.touches(i); }), "axes of the contact");
            check_equal(found.gap, reaches(map, [&](std::int64_t i) { return included(map, i) && !map.touches(i); }),
                        "axes of the gap");
            ++crossed[found.contact & RC_CROSSES_X];
            check_histogram(map, repeat == 0 ? 0 : repeat == 1 ? 0.37 : 5);
            ++maps;
          }
  report(std::to_string(maps) + " maps");
  check(crossed[0] > 50 && crossed[1] > 50, "maps of both kinds");
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

void check_counts(const Histogram& found, const std::vector<std::int64_t>& expected) {
  for (std::size_t k = 0; k < expected.size(); ++k)
    check_equal(found.counts[k], expected[k], "counts[" + std::to_string(k) + "]");
}

void bins_hold_their_upper_ends() {
  const Map map = drawn({"0124", "3.4."});
  const Histogram all = histogram_of(map, 4, 0);
  check_counts(all, {1, 1, 1, 2});
  check_near(all.said.width, 1, 0, "width");
  check_equal(all.said.contacts, 5, "contacts");
  check_equal(all.said.above, 0, "above");
  check_near(all.said.mean_pressure, 2.8, 1e-15, "mean pressure");
  check_near(all.said.max_pressure, 4, 0, "largest pressure");
  check_near(all.density, {0.2, 0.2, 0.2, 0.4}, 1e-15, "density");
  const Histogram low = histogram_of(map, 4, 2);
  check_counts(low, {0, 1, 0, 1});
  check_near(low.said.width, 0.5, 0, "width");
  check_equal(low.said.above, 3, "above");
  check_near(low.density, {0, 0.4, 0, 0.4}, 1e-15, "density");
}

void no_contact_is_zero() {
  const Map map = drawn({"...", "x.."});
  for (const double upper : {0.0, 2.0}) {
    const Histogram found = histogram_of(map, 2, upper);
    check_counts(found, {0, 0});
    check_near(found.density, {0, 0}, 0, "density");
    check_near(found.said.width, upper / 2, 0, "width");
    check_equal(found.said.contacts + found.said.above, 0, "contacts");
    check_near(found.said.mean_pressure + found.said.max_pressure, 0, 0, "pressures");
  }
}

// Hertz's pressure p0 sqrt(1 - r^2/a^2) is below p on a share p^2/p0^2 of the area.
void hertz_pressures_have_a_linear_density() {
  constexpr std::int64_t n = 401, bins = 10;
  constexpr double radius = 180, p0 = 3;
  Map map;
  map.system.nx = map.system.ny = n;
  for (std::int64_t i = 0; i < n * n; ++i) {
    const double r = std::hypot(static_cast<double>(i % n - n / 2), static_cast<double>(i / n - n / 2)) / radius;
    map.p.push_back(r < 1 ? p0 * std::sqrt(1 - r * r) : 0);
  }
  const Histogram found = histogram_of(map, bins, p0);
  for (std::size_t k = 0; k < bins; ++k) {
    const double middle = (static_cast<double>(k) + 0.5) * found.said.width;
    check_near(found.density[k], 2 * middle / (p0 * p0), 0.005 * 2 / p0, "density");
  }
  check_near(found.said.mean_pressure, 2 * p0 / 3, 1e-3, "mean pressure");
}

void arrays_may_be_left_out() {
  const Map map = drawn({"0124", "3.4."});
  rc_histogram said = RC_HISTOGRAM_INIT;
  said.bins = 3;
  check(rc_histogram_fill(&map.system, RC_IN(map.p.data()), {}, &said) == RC_OK, rc_last_error());
  check_equal(said.contacts, 5, "contacts");
  Field density(3, -7);
  said.density = RC_OUT(density.data());
  check(rc_histogram_fill(&map.system, RC_IN(map.p.data()), {}, &said) == RC_OK, rc_last_error());
  check_near(sum(density) * said.width, 1, 1e-15, "sum of the shares");
}

}  // namespace

}  // namespace analysis

int main(int argc, char** argv) {
  using namespace analysis;
  return pairs::run_group("analysis",
                          {{"drawn_areas", drawn_areas},
                           {"drawn_crossings", drawn_crossings},
                           {"patches_have_the_numbers_that_are_drawn", patches_have_their_numbers},
                           {"room_for_fewer_patches_takes_the_first", room_for_fewer_patches},
                           {"random_maps_are_as_a_flood_fill_finds_them", random_maps_are_as_flooded},
                           {"corrected_area_of_spheres_is_closer_to_hertz", correction_helps_spheres},
                           {"bins_hold_their_upper_ends", bins_hold_their_upper_ends},
                           {"no_contact_has_no_density", no_contact_is_zero},
                           {"pressures_of_hertz_have_a_linear_density", hertz_pressures_have_a_linear_density},
                           {"arrays_may_be_left_out", arrays_may_be_left_out}},
                          argc, argv);
}
