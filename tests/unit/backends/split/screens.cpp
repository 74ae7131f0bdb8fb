// Overlapping points against products at all points.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "scene.h"
#include "support/cmocka.hpp"
#include "support/harness.h"

namespace split {

namespace {

struct Surface {
  Vector gap;
  std::vector<std::uint8_t> mask;
  double approach, unit;
};

using Overlap = std::vector<std::pair<std::int64_t, double>>;  // points and depths, by ascending point

// All of them, by products at all points outside the domain.
Overlap overlap(const Grid& grid, const Index& domain, const Vector& x, const Surface& surface) {
  std::vector<char> inside(static_cast<std::size_t>(grid.points()));
  for (const std::int64_t i : domain) inside[static_cast<std::size_t>(i)] = 1;
  Index others;
  for (std::int64_t i = 0; i < grid.points(); ++i)
    if (!inside[static_cast<std::size_t>(i)] && (surface.mask.empty() || surface.mask[static_cast<std::size_t>(i)]))
      others.push_back(i);
  const Vector w = Reference(grid).product(others, domain, x);
  Overlap result;
  for (std::size_t k = 0; k < others.size(); ++k) {
    const double depth = surface.approach - surface.gap[static_cast<std::size_t>(others[k])] - surface.unit * w[k];
    if (depth > 0) result.emplace_back(others[k], depth);
  }
  return result;
}

struct Answer {
  Vector y;
  Overlap found;
  std::int64_t n_found;
};

Answer screened(Operator& op, const Index& domain, const Vector& x, const Surface& surface, std::size_t room,
                const double* tile_lowest = nullptr, std::int64_t first_row = 0, std::int64_t rows = 0) {
  Answer answer{Vector(domain.size()), {}, -1};
  Index point(room);
  Vector depth(room);
  rc_screen request{.struct_size = sizeof(rc_screen),
                    .approach = surface.approach,
                    .unit = surface.unit,
                    .undeformed_gap = {surface.gap.data(), RC_NATIVE, 0, nullptr},
                    .mask = surface.mask.empty() ? nullptr : surface.mask.data(),
                    .tile_lowest = tile_lowest,
                    .first_row = first_row,
                    .rows = rows,
                    .y = answer.y.data(),
                    .room = static_cast<std::int64_t>(room),
                    .found = point.data(),
                    .depth = depth.data(),
                    .n_found = 0};
  op.screen(x, request);
  answer.n_found = request.n_found;
  for (std::size_t k = 0; k < std::min(room, static_cast<std::size_t>(request.n_found)); ++k)
    answer.found.emplace_back(point[k], depth[k]);
  std::sort(answer.found.begin(), answer.found.end());
  return answer;
}

// A few waves; the domain is what lies below some depth, so that some overlap remains here and there.
struct Scene {
  Grid grid;
  Index domain;
  Vector x;
  Surface surface;
};

Scene dilute_scene(const Grid& grid, Random& random, bool masked) {
  Scene scene{grid, {}, {}, {Vector(static_cast<std::size_t>(grid.points())), {}, 0, 0}};
  double waves[8][4];
  for (auto& wave : waves) {
    wave[0] = (uniform(random) - 0.5) * 0.7;
    wave[1] = (uniform(random) - 0.5) * 0.7;
    wave[2] = uniform(random) * 6.28;
    wave[3] = 1 / (1 + 10 * std::hypot(wave[0], wave[1]));
  }
  for (std::int64_t i = 0; i < grid.points(); ++i) {
    double& gap = scene.surface.gap[static_cast<std::size_t>(i)];
    for (const auto& wave : waves)
      gap +=
          wave[3] * std::cos(wave[0] * static_cast<double>(i % grid.nx) + wave[1] * static_cast<double>(i / grid.nx) + wave[2]);
    if (masked) scene.surface.mask.push_back(uniform(random) < 0.8 ? 1 : 0);
  }
  Vector sorted = scene.surface.gap;
  std::sort(sorted.begin(), sorted.end());
  const double low = sorted[sorted.size() / 100];  // below: pressed
  for (std::int64_t i = 0; i < grid.points(); ++i)
    if (scene.surface.gap[static_cast<std::size_t>(i)] < low) scene.domain.push_back(i);
  scene.x = pressures(scene.domain, random);
  scene.surface.unit = 0.1 + uniform(random);
  const Vector w = Reference(grid).product(scene.domain, scene.domain, scene.x);
  scene.surface.approach = low + scene.surface.unit * largest(w) * (0.1 + 0.9 * uniform(random));
  for (std::size_t i = 0; i < scene.surface.mask.size(); ++i)
    if (!scene.surface.mask[i]) scene.surface.gap[i] = -1e30;  // what lies there may hold anything
  return scene;
}

void check_scene(const Scene& scene, const char* spacing) {
  const Overlap expected = overlap(scene.grid, scene.domain, scene.x, scene.surface);
  Operator op(scene.grid, spacing);
  op.bind(scene.domain);
  const Answer answer = screened(op, scene.domain, scene.x, scene.surface, static_cast<std::size_t>(scene.grid.points()));
  assert_int_equal(answer.n_found, static_cast<std::int64_t>(expected.size()));
  assert_int_equal(answer.found.size(), expected.size());
  const double scale = scene.surface.unit * largest(answer.y);
  for (std::size_t k = 0; k < expected.size(); ++k) {
    assert_int_equal(answer.found[k].first, expected[k].first);
    assert_true(std::abs(answer.found[k].second - expected[k].second) <= 1e-9 * (1 + scale));
  }
  assert_true(largest_difference(answer.y, op.apply(scene.x)) <= 1e-10 * largest(answer.y));
}

}  // namespace

// Random scenes: every point that overlaps is found, and no other.
void screen_finds_what_overlaps(void**) {
  const int scenes = pairs::quick() ? 20 : 200;
  for (int seed = 0; seed < scenes; ++seed) {
    Random random(static_cast<unsigned>(seed));
    const Grid grid{130 + static_cast<std::int64_t>(random() % 60), 120 + static_cast<std::int64_t>(random() % 60), 1.0, 1.0,
                    "love"};
    const char* const spacings[] = {"auto", "4", "8", "16"};
    check_scene(dilute_scene(grid, random, seed % 3 == 0), spacings[seed % 4]);
  }
}

// A flat surface with one other point far from the pressure, where the bound is almost the product itself.
void screen_proves_no_more_than_holds(void**) {
  const Grid grid{400, 310, 1.0, 1.0, "love"};
  const Index domain{5 * 400 + 7, 5 * 400 + 8, 20 * 400 + 3};
  const Vector x{1.0, 0.5, 2.0};
  for (const char* spacing : {"4", "8", "16"}) {
    Operator op(grid, spacing);
    op.bind(domain);
    for (const std::int64_t point :
         {grid.points() - 1, grid.points() - 8, 200 * grid.nx + 207, 300 * grid.nx + 120, 150 * grid.nx + 399}) {
      const double w = Reference(grid).product({point}, domain, x)[0];
      for (const double part : {0.9999, 1.0001}) {
        Surface surface{Vector(static_cast<std::size_t>(grid.points()), 10.0), {}, 1.0, 1.0};
        surface.gap[static_cast<std::size_t>(point)] = surface.approach - part * w;
        const Answer answer = screened(op, domain, x, surface, 4);
        assert_int_equal(answer.n_found, part > 1 ? 1 : 0);
        if (part > 1) assert_int_equal(answer.found[0].first, point);
      }
    }
  }
}

void screen_counts_beyond_its_room(void**) {
  Random random(11);
  Scene scene = dilute_scene({180, 170, 1.0, 1.0, "love"}, random, false);
  scene.surface.approach += 1;
  const Overlap expected = overlap(scene.grid, scene.domain, scene.x, scene.surface);
  assert_true(expected.size() > 20);
  Operator op(scene.grid);
  op.bind(scene.domain);
  for (const std::size_t room : {std::size_t{0}, std::size_t{7}, expected.size()}) {
    const Answer answer = screened(op, scene.domain, scene.x, scene.surface, room);
    assert_int_equal(answer.n_found, static_cast<std::int64_t>(expected.size()));
    assert_int_equal(answer.found.size(), room);
    for (const auto& [point, depth] : answer.found)
      assert_true(std::ranges::binary_search(expected, point, {}, [](const auto& each) { return each.first; }));
  }
}

void screen_of_nothing_finds_all_below_the_approach(void**) {
  Random random(13);
  Scene scene = dilute_scene({180, 170, 1.0, 1.0, "love"}, random, false);
  std::fill(scene.x.begin(), scene.x.end(), 0.0);
  check_scene(scene, "auto");
  scene.surface.approach = -1e6;
  check_scene(scene, "auto");
}

namespace {

// The lowest gap of each tile over its points that are not masked.
Vector lowest_of_tiles(const Grid& grid, const Surface& surface) {
  const std::int64_t columns = (grid.nx + 15) / 16, rows = (grid.ny + 15) / 16;
  Vector lowest(static_cast<std::size_t>(columns * rows), std::numeric_limits<double>::infinity());
  for (std::int64_t i = 0; i < grid.points(); ++i) {
    const auto point = static_cast<std::size_t>(i);
    double& least = lowest[static_cast<std::size_t>(i / grid.nx / 16 * columns + i % grid.nx / 16)];
    if (surface.mask.empty() || surface.mask[point]) least = std::min(least, surface.gap[point]);
  }
  return lowest;
}

}  // namespace

// Parts of the rows, whose ends need not be those of tiles, find together what all rows find.
void parts_of_a_screen_and_known_lowest_gaps_change_nothing(void**) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    Random random(20 + seed);
    const Scene scene = dilute_scene({220, 201, 1.0, 1.0, "love"}, random, seed % 2 == 1);
    const Vector lowest = lowest_of_tiles(scene.grid, scene.surface);
    Operator op(scene.grid);
    op.bind(scene.domain);
    const auto room = static_cast<std::size_t>(scene.grid.points());
    const Answer whole = screened(op, scene.domain, scene.x, scene.surface, room);
    const Answer known = screened(op, scene.domain, scene.x, scene.surface, room, lowest.data());
    assert_true(known.y == whole.y && known.found == whole.found);
    Overlap found;
    for (const auto& [first, end] : {std::pair<std::int64_t, std::int64_t>{0, 56}, {56, 57}, {57, 121}, {121, 201}}) {
      const auto of_rows = [&, begin = first * scene.grid.nx, stop = end * scene.grid.nx](const auto& all) {
        return std::remove_cvref_t<decltype(all)>(all.begin() + begin, all.begin() + stop);
      };
      Surface part{of_rows(scene.surface.gap), {}, scene.surface.approach, scene.surface.unit};
      if (!scene.surface.mask.empty()) part.mask = of_rows(scene.surface.mask);
      const Answer answer = screened(op, scene.domain, scene.x, part, room, nullptr, first, end - first);
      assert_true(answer.y == whole.y);
      found.insert(found.end(), answer.found.begin(), answer.found.end());
    }
    assert_true(whole.n_found > 0 && found == whole.found);
  }
}

// Gaps of a tile whose lowest gap is given are not read.
void tiles_known_to_lie_apart_are_not_looked_at(void**) {
  const Grid grid{200, 170, 1.0, 1.0, "love"};
  const std::int64_t point = 150 * grid.nx + 180;
  Surface surface{Vector(static_cast<std::size_t>(grid.points()), 10.0), {}, 1.0, 1.0};
  surface.gap[static_cast<std::size_t>(point)] = -10.0;
  Vector lowest = lowest_of_tiles(grid, surface);
  lowest[static_cast<std::size_t>(150 / 16 * 13 + 180 / 16)] = 10.0;
  const Index domain{0, 1};
  Operator op(grid);
  op.bind(domain);
  const auto found = [&](const double* tile_lowest) { return screened(op, domain, {1.0, 1.0}, surface, 4, tile_lowest).n_found; };
  assert_int_equal(found(nullptr), 1);
  assert_int_equal(found(lowest.data()), 0);
}

const std::vector<CMUnitTest> screen_tests = {
    cmocka_unit_test(screen_finds_what_overlaps),
    cmocka_unit_test(screen_proves_no_more_than_holds),
    cmocka_unit_test(screen_counts_beyond_its_room),
    cmocka_unit_test(screen_of_nothing_finds_all_below_the_approach),
    cmocka_unit_test(parts_of_a_screen_and_known_lowest_gaps_change_nothing),
    cmocka_unit_test(tiles_known_to_lie_apart_are_not_looked_at),
};

}  // namespace split
