// Whether contact and gap reach across: drawn cells, and random ones against a walk from side to side.
#include <queue>
#include <set>

#include "maps.h"

namespace analysis {

namespace {

using namespace pairs;

constexpr std::int32_t free_sides = RC_BOUNDARY_FREE, periodic = RC_BOUNDARY_PERIODIC, periodic_x = RC_BOUNDARY_PERIODIC_X,
                       periodic_y = RC_BOUNDARY_PERIODIC_Y;

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

void check_crossing(const Map& map, const std::string& contact, const std::string& gap) {
  const auto sum = [](const std::string& axes) {
    return axes.empty() ? RC_CROSSES_NONE : axes == "x" ? RC_CROSSES_X : axes == "y" ? RC_CROSSES_Y : RC_CROSSES_X + RC_CROSSES_Y;
  };
  const Crossing found = crossing_of(map);
  check(found.contact == sum(contact), "the contact crosses along " + contact);
  check(found.gap == sum(gap), "the gap crosses along " + gap);
}

void ridges_cross_along_themselves() {
  check_crossing(drawn({"...", "###", "..."}), "x", "x");
  check_crossing(drawn({".#.", ".#.", ".#."}), "y", "y");
  check_crossing(drawn({".#.", "###", ".#."}), "xy", "");
  check_crossing(drawn({"###", "###"}), "xy", "");
  check_crossing(drawn({"..", ".."}), "", "xy");
}

void corners_do_not_connect() { check_crossing(drawn({"#..", ".#.", "..#"}), "", ""); }

// The inlet and the outlet of a seal stay apart; across the flow the surface repeats.
void sides_along_the_axis_stay_apart_and_those_beside_it_join() {
  check_crossing(drawn({"#..", "...", "..#"}, periodic), "", "xy");
  check_crossing(drawn({"##.", ".##", "..."}), "x", "x");
  check_crossing(drawn({"##..", ".##.", "..##", "#..#"}, periodic), "xy", "xy");
  check_crossing(drawn({"....", "##.#", "...."}, periodic), "", "xy");
  check_crossing(drawn({"....", "####", "...."}, periodic), "x", "x");
  // A channel that leaves at the lower side and comes back at the upper one, and ends at another height than it began.
  const std::vector<std::string> wrapping{"#.##", "#.##", "..##", "####", "#..."},
      inverse{".#..", ".#..", "##..", "....", ".###"};
  for (const std::int32_t boundary : {periodic, periodic_y}) {
    check_crossing(drawn(wrapping, boundary), "xy", "x");
    check_crossing(drawn(inverse, boundary), "x", "xy");
  }
  check_crossing(transposed(drawn(wrapping, periodic)), "xy", "y");
  for (const std::int32_t boundary : {free_sides, periodic_x}) {
    check_crossing(drawn(wrapping, boundary), "xy", "");
    check_crossing(drawn(inverse, boundary), "", "xy");
  }
}

void masked_points_are_neither() {
  check_crossing(drawn({"##x##", "##x##"}), "y", "");
  check_crossing(drawn({"..x..", "..x.."}), "", "y");
}

// From every cell of one side: whether a walk reaches the opposite one. It goes on across the axis where the grid repeats.
bool walks_across(const Map& map, bool contact, bool along_x) {
  const std::int64_t nx = map.system.nx, ny = map.system.ny;
  const std::int32_t boundary = map.system.boundary;
  const bool around = boundary == periodic || boundary == (along_x ? RC_BOUNDARY_PERIODIC_Y : RC_BOUNDARY_PERIODIC_X);
  using Place = std::pair<std::int64_t, std::int64_t>;  // along the axis, across it
  const std::int64_t length = along_x ? nx : ny, width = along_x ? ny : nx;
  const auto inside = [&](const Place& place) {
    if (place.first < 0 || place.first >= length || place.second < 0 || place.second >= width) return false;
    const std::int64_t i = along_x ? place.second * nx + place.first : place.first * nx + place.second;
    const bool counted = map.mask.empty() || map.mask[static_cast<std::size_t>(i)] != 0;
    return counted && map.touches(i) == contact;
  };
  std::set<Place> met;
  std::queue<Place> border;
  for (std::int64_t start = 0; start < width; ++start)
    if (inside({0, start}) && met.insert({0, start}).second) border.push({0, start});
  while (!border.empty()) {
    const Place at = border.front();
    border.pop();
    if (at.first == length - 1) return true;
    for (const Place& step : {Place{1, 0}, Place{-1, 0}, Place{0, 1}, Place{0, -1}}) {
      Place next{at.first + step.first, at.second + step.second};
      if (around) next.second = (next.second + width) % width;
      if (inside(next) && met.insert(next).second) border.push(next);
    }
  }
  return false;
}

void random_maps_cross_as_walks_do() {
  std::mt19937_64 random(5);
  int crossed[2] = {};
  for (const auto& [nx, ny] : {std::pair<std::int64_t, std::int64_t>{1, 1}, {1, 4}, {4, 1}, {2, 3}, {5, 5}, {9, 7}})
    for (const std::int32_t boundary : {free_sides, periodic, periodic_x, periodic_y})
      for (const double share : {0.3, 0.5, 0.65, 0.8})
        for (const double masked : {0.0, 0.1})
          for (int repeat = 0; repeat < 4; ++repeat) {
            const Map map = random_map(nx, ny, boundary, share, masked, random);
            const Crossing found = crossing_of(map);
            const auto walked = [&](bool contact) {
              return (walks_across(map, contact, true) ? RC_CROSSES_X : 0) +
                     (walks_across(map, contact, false) ? RC_CROSSES_Y : 0);
            };
            check_equal(found.contact, walked(true), "axes of the contact");
            check_equal(found.gap, walked(false), "axes of the gap");
            ++crossed[found.contact & RC_CROSSES_X];
          }
  check(crossed[0] > 50 && crossed[1] > 50, "maps of both kinds");
}

}  // namespace

std::vector<Test> crossing_tests() {
  return {{"ridges_cross_along_themselves", ridges_cross_along_themselves},
          {"corners_do_not_connect", corners_do_not_connect},
          {"sides_along_the_axis_stay_apart_and_those_beside_it_join", sides_along_the_axis_stay_apart_and_those_beside_it_join},
          {"masked_points_are_neither_contact_nor_gap", masked_points_are_neither},
          {"random_maps_cross_as_walks_do", random_maps_cross_as_walks_do}};
}

}  // namespace analysis
