// Whether contact and gap reach across: drawn cells, and random ones against a walk on the unrolled grid.
#include <queue>
#include <set>

#include "maps.h"

namespace analysis {

namespace {

using namespace pairs;

constexpr std::int32_t free_sides = RC_BOUNDARY_FREE, periodic = RC_BOUNDARY_PERIODIC;

rc_crossing crossing_of(const Map& map) {
  rc_crossing found{sizeof(rc_crossing), -7, -7, -7, -7};
  check(rc_crossing_find(&map.system, map.p.data(), map.mask_data(), &found) == RC_OK, rc_last_error());
  return found;
}

void check_crossing(const Map& map, const std::string& contact, const std::string& gap) {
  const auto text = [](std::int32_t x, std::int32_t y) { return std::string(x ? "x" : "") + (y ? "y" : ""); };
  const rc_crossing found = crossing_of(map);
  check(text(found.contact_x, found.contact_y) == contact, "the contact crosses along " + contact);
  check(text(found.gap_x, found.gap_y) == gap, "the gap crosses along " + gap);
}

void ridges_cross_along_themselves() {
  check_crossing(drawn({"...", "###", "..."}), "x", "x");
  check_crossing(drawn({".#.", ".#.", ".#."}), "y", "y");
  check_crossing(drawn({".#.", "###", ".#."}), "xy", "");
  check_crossing(drawn({"###", "###"}), "xy", "");
  check_crossing(drawn({"..", ".."}), "", "xy");
}

void corners_do_not_connect() { check_crossing(drawn({"#..", ".#.", "..#"}), "", ""); }

void periodic_parts_must_meet_themselves() {
  check_crossing(drawn({"#..", "...", "..#"}, periodic), "", "xy");
  // Both sides are touched, but a period further the part is another one.
  check_crossing(drawn({"##.", ".##", "..."}), "x", "x");
  check_crossing(drawn({"##..", ".##.", "..##", "#..#"}, periodic), "xy", "xy");
  check_crossing(drawn({"....", "##.#", "...."}, periodic), "", "xy");
  check_crossing(drawn({"....", "####", "...."}, periodic), "x", "x");
}

void masked_points_are_neither() {
  check_crossing(drawn({"##x##", "##x##"}), "y", "");
  check_crossing(drawn({"..x..", "..x.."}), "", "y");
}

// Along each direction: from every cell, the copies of itself that a walk on the unrolled grid reaches.
bool walks_around(const Map& map, bool contact, bool along_x) {
  const std::int64_t nx = map.system.nx, ny = map.system.ny;
  const bool around = map.system.boundary == periodic;
  using Place = std::pair<std::int64_t, std::int64_t>;
  const auto wrapped = [](std::int64_t value, std::int64_t n) { return (value % n + n) % n; };
  const auto inside = [&](Place place) {
    if (!around && (place.first < 0 || place.first >= nx || place.second < 0 || place.second >= ny)) return false;
    const std::int64_t i = wrapped(place.second, ny) * nx + wrapped(place.first, nx);
    const bool counted = map.mask.empty() || map.mask[static_cast<std::size_t>(i)] != 0;
    return counted && map.touches(i) == contact;
  };
  for (std::int64_t start = 0; start < nx * ny; ++start) {
    const Place from{start % nx, start / nx};
    if (!inside(from)) continue;
    std::set<Place> met{from};
    std::queue<Place> border({from});
    bool low = false, high = false;
    while (!border.empty()) {
      const Place at = border.front();
      border.pop();
      const std::int64_t along = along_x ? at.first : at.second, n = along_x ? nx : ny;
      low = low || along == 0;
      high = high || along == n - 1;
      const bool itself = wrapped(at.first, nx) == from.first && wrapped(at.second, ny) == from.second;
      if (around && itself && along != (along_x ? from.first : from.second)) return true;
      for (const Place& step : {Place{1, 0}, Place{-1, 0}, Place{0, 1}, Place{0, -1}}) {
        const Place next{at.first + step.first, at.second + step.second};
        if (std::abs(next.first) > 3 * nx || std::abs(next.second) > 3 * ny) continue;
        if (inside(next) && met.insert(next).second) border.push(next);
      }
    }
    if (!around && low && high) return true;
  }
  return false;
}

void random_maps_cross_as_walks_do() {
  std::mt19937_64 random(5);
  int crossed[2] = {};
  for (const auto& [nx, ny] : {std::pair<std::int64_t, std::int64_t>{1, 1}, {1, 4}, {4, 1}, {2, 3}, {5, 5}, {9, 7}})
    for (const std::int32_t boundary : {free_sides, periodic})
      for (const double share : {0.3, 0.5, 0.65, 0.8})
        for (const double masked : {0.0, 0.1})
          for (int repeat = 0; repeat < 4; ++repeat) {
            const Map map = random_map(nx, ny, boundary, share, masked, random);
            const rc_crossing found = crossing_of(map);
            check_equal(found.contact_x, walks_around(map, true, true), "contact along x");
            check_equal(found.contact_y, walks_around(map, true, false), "contact along y");
            check_equal(found.gap_x, walks_around(map, false, true), "gap along x");
            check_equal(found.gap_y, walks_around(map, false, false), "gap along y");
            ++crossed[found.contact_x];
          }
  check(crossed[0] > 50 && crossed[1] > 50, "maps of both kinds");
}

}  // namespace

std::vector<Test> crossing_tests() {
  return {{"ridges_cross_along_themselves", ridges_cross_along_themselves},
          {"corners_do_not_connect", corners_do_not_connect},
          {"periodic_parts_must_meet_themselves", periodic_parts_must_meet_themselves},
          {"masked_points_are_neither_contact_nor_gap", masked_points_are_neither},
          {"random_maps_cross_as_walks_do", random_maps_cross_as_walks_do}};
}

}  // namespace analysis
