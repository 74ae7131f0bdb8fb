// Patches: drawn ones, and random maps against a flood fill.
#include <algorithm>
#include <tuple>

#include "maps.h"

namespace analysis {

namespace {

using namespace pairs;

void check_numbers(const std::vector<std::int64_t>& found, const std::vector<std::int64_t>& expected, const std::string& what) {
  check_equal(static_cast<std::int64_t>(found.size()), static_cast<std::int64_t>(expected.size()), what + ", length");
  for (std::size_t i = 0; i < found.size(); ++i) check_equal(found[i], expected[i], what + "[" + std::to_string(i) + "]");
}

void check_count(const Map& map, std::int64_t edges, std::int64_t corners) {
  check_equal(patches_of(map, 4).count, edges, "patches across edges");
  check_equal(patches_of(map, 8).count, corners, "patches across edges and corners");
}

void corners_join_eight_neighbours() {
  check_count(drawn({"....", ".#..", "..#.", "...."}), 2, 1);
  check_count(drawn({"....", "..#.", ".#..", "...."}), 2, 1);
  check_count(drawn({"#.#.#.", ".#.#.#", "#.#.#.", ".#.#.#"}), 12, 1);
  check_count(drawn({"##..", "..##", "##..", "...."}), 3, 1);
  check_count(drawn({"#..", "...", "..#"}), 2, 2);
}

void sides_join_periodic_grids() {
  const std::vector<std::string> left_right = {"....", "#..#", "...."}, top_bottom = {".#..", "....", ".#.."},
                                 corner = {"#...", "....", "...#"}, shifted = {"#...", "...#", "...."};
  for (const auto& rows : {left_right, top_bottom}) {
    check_count(drawn(rows), 2, 2);
    check_count(drawn(rows, RC_BOUNDARY_PERIODIC), 1, 1);
  }
  for (const auto& rows : {corner, shifted}) {
    check_count(drawn(rows), 2, 2);
    check_count(drawn(rows, RC_BOUNDARY_PERIODIC), 2, 1);
  }
  check_count(drawn({"#..#", "....", "....", "#..#"}, RC_BOUNDARY_PERIODIC), 1, 1);
}

void long_ways_round_are_found() {
  check_count(drawn({"#########", "........#", "#######.#", "#.....#.#", "#.###.#.#", "#.#...#.#", "#.#####.#", "#.......#",
                     "#########"}),
              1, 1);
  check_count(drawn({"#.#.#.#", "#.#.#.#", "#######"}), 1, 1);
  check_count(drawn({"#######", "#.#.#.#", "#.#.#.#"}), 1, 1);
  check_count(drawn({"#.#.#.#", "#.#.#.#", "###.###"}), 2, 2);
}

void masked_cells_part() {
  check_count(drawn({"...", "#x#", "..."}), 2, 2);
  check_count(drawn({"x#x", "#x#", "x#x"}), 4, 1);
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
  check_equal(patches_of(drawn({"...", "..."}), 8).count, 0, "no contact");
}

// From each point that has no label yet, everything that can be reached by steps to neighbours.
Patches flooded(const Map& map, std::int32_t neighbours) {
  const std::int64_t nx = map.system.nx, ny = map.system.ny;
  const bool periodic = map.system.boundary == RC_BOUNDARY_PERIODIC;
  constexpr std::int64_t steps[8][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
  const auto next = [&](std::int64_t i, const std::int64_t(&step)[2]) -> std::int64_t {
    std::int64_t x = i % nx + step[0], y = i / nx + step[1];
    if (periodic) {
      x = (x + nx) % nx;
      y = (y + ny) % ny;
    }
    return x >= 0 && x < nx && y >= 0 && y < ny ? y * nx + x : -1;
  };
  Patches found;
  found.count = 0;
  found.label.assign(map.points(), -1);
  for (std::int64_t start = 0; start < nx * ny; ++start) {
    if (!map.touches(start) || found.label[static_cast<std::size_t>(start)] >= 0) continue;
    std::vector<std::int64_t> waiting = {start};
    found.label[static_cast<std::size_t>(start)] = found.count;
    std::int64_t cells = 0;
    double load = 0, perimeter = 0, largest = 0;
    while (!waiting.empty()) {
      const std::int64_t i = waiting.back();
      waiting.pop_back();
      ++cells;
      const double p = map.p[static_cast<std::size_t>(i)];
      load += p * map.cell();
      largest = std::max(largest, p);
      for (std::int32_t k = 0; k < neighbours; ++k) {
        const std::int64_t j = next(i, steps[k]);
        const bool in_contact = j >= 0 && map.touches(j);
        if (!in_contact && k < 4) perimeter += k < 2 ? map.system.hy : map.system.hx;
        if (!in_contact || found.label[static_cast<std::size_t>(j)] >= 0) continue;
        found.label[static_cast<std::size_t>(j)] = found.count;
        waiting.push_back(j);
      }
    }
    ++found.count;
    found.cells.push_back(cells);
    found.load.push_back(load);
    found.perimeter.push_back(perimeter);
    found.max_pressure.push_back(largest);
  }
  return found;
}

void random_maps_are_as_flooded() {
  std::mt19937_64 random(3);
  std::int64_t maps = 0;
  for (const auto& [nx, ny] :
       {std::pair<std::int64_t, std::int64_t>{1, 1}, {1, 7}, {7, 1}, {2, 2}, {2, 5}, {3, 3}, {17, 23}, {40, 31}})
    for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
      for (const double share : {0.05, 0.3, 0.45, 0.6, 0.75, 1.0})
        for (const double masked : {0.0, 0.15})
          for (int repeat = 0; repeat < 4; ++repeat) {
            const Map map = random_map(nx, ny, boundary, share, masked, random);
            const rc_area area = area_of(map);
            for (const std::int32_t neighbours : {4, 8}) {
              const Patches found = patches_of(map, neighbours), expected = flooded(map, neighbours);
              check_numbers(found.label, expected.label, "label");
              check_numbers(found.cells, expected.cells, "cells");
              check_near(found.load, expected.load, 1e-13, "load");
              check_near(found.perimeter, expected.perimeter, 1e-13, "perimeter");
              check_near(found.max_pressure, expected.max_pressure, 0, "largest pressure");
              check_near(sum(found.perimeter), area.perimeter, 1e-12 * area.perimeter, "perimeter of all patches");
              check_near(sum(found.area), area.area, 1e-12 * area.area, "area of all patches");
              for (std::size_t k = 0; k < found.cells.size(); ++k) {
                const auto peak = static_cast<std::size_t>(found.peak[k]);
                check_equal(found.label[peak], static_cast<std::int64_t>(k), "the peak's patch");
                check_near(map.p[peak], found.max_pressure[k], 0, "pressure at the peak");
                check_near(found.mean_pressure[k], found.load[k] / found.area[k], 1e-14 * found.max_pressure[k], "mean pressure");
              }
            }
            ++maps;
          }
  report(std::to_string(maps) + " maps");
}

void axes_of_patches_change_places() {
  std::mt19937_64 random(4);
  const auto sorted = [](const Patches& found) {
    std::vector<std::tuple<std::int64_t, double, double>> list;
    for (std::size_t k = 0; k < found.cells.size(); ++k)
      list.emplace_back(found.cells[k], found.max_pressure[k], found.perimeter[k]);
    std::sort(list.begin(), list.end());
    return list;
  };
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
    for (const std::int32_t neighbours : {4, 8}) {
      const Map map = random_map(25, 14, boundary, 0.45, 0.05, random);
      check(sorted(patches_of(map, neighbours)) == sorted(patches_of(transposed(map), neighbours)), "the same patches");
    }
}

}  // namespace

std::vector<Test> patch_tests() {
  return {{"corners_join_eight_neighbours", corners_join_eight_neighbours},
          {"sides_join_where_the_grid_is_periodic", sides_join_periodic_grids},
          {"long_ways_round_are_found", long_ways_round_are_found},
          {"masked_cells_part_patches", masked_cells_part},
          {"patches_have_the_numbers_that_are_drawn", patches_have_their_numbers},
          {"room_for_fewer_patches_takes_the_first", room_for_fewer_patches},
          {"random_maps_are_as_a_flood_fill_finds_them", random_maps_are_as_flooded},
          {"transposition_keeps_the_patches", axes_of_patches_change_places}};
}

}  // namespace analysis
