#include "analysis/crossing.h"

#include <cstddef>
#include <vector>

namespace rc {

namespace {

struct Directions {
  bool x = false, y = false;
};

struct Shift {
  std::int64_t x = 0, y = 0;  // periods

  Shift operator+(Shift other) const { return {x + other.x, y + other.y}; }
  Shift operator-(Shift other) const { return {x - other.x, y - other.y}; }
};

constexpr unsigned left = 1, right = 2, top = 4, bottom = 8;  // sides of the grid

// Connected stretches of rows. Each has its shift against its root, so that two ways between the same stretches show whether one
// of them goes around the grid.
class Clusters {
 public:
  std::size_t add(unsigned sides) {
    nodes_.push_back({nodes_.size(), {}, sides});
    return nodes_.size() - 1;
  }

  // The second stretch, shifted, is adjacent to the first.
  void join(std::size_t first, std::size_t second, Shift shift) {
    const Place a = find(first), b = find(second);
    const Shift between = a.shift + shift - b.shift;
    if (a.root == b.root) {
      around_.x = around_.x || between.x != 0;
      around_.y = around_.y || between.y != 0;
      return;
    }
    nodes_[b.root].parent = a.root;
    nodes_[b.root].shift = between;
    nodes_[a.root].sides |= nodes_[b.root].sides;
  }

  Directions crossing() const {
    Directions found = around_;
    for (const Node& node : nodes_) {
      found.x = found.x || (node.sides & (left | right)) == (left | right);
      found.y = found.y || (node.sides & (top | bottom)) == (top | bottom);
    }
    return found;
  }

 private:
  struct Node {
    std::size_t parent;
    Shift shift;     // against the parent
    unsigned sides;  // that a root's runs touch
  };
  struct Place {
    std::size_t root;
    Shift shift;
  };

  Place find(std::size_t node) {
    Place place{node, {}};
    for (; nodes_[place.root].parent != place.root; place.root = nodes_[place.root].parent)
      place.shift = place.shift + nodes_[place.root].shift;
    Shift rest = place.shift;
    while (node != place.root) {  // the next search is short
      const Node here = nodes_[node];
      nodes_[node].parent = place.root;
      nodes_[node].shift = rest;
      rest = rest - here.shift;
      node = here.parent;
    }
    return place;
  }

  std::vector<Node> nodes_;
  Directions around_;
};

struct Stretch {
  std::int64_t begin, end;
  std::size_t number;
};

void join_rows(const std::vector<Stretch>& above, const std::vector<Stretch>& below, Shift shift, Clusters& clusters) {
  auto lower = below.begin();
  for (auto upper = above.begin(); upper != above.end() && lower != below.end();) {
    if (upper->begin < lower->end && lower->begin < upper->end) clusters.join(upper->number, lower->number, shift);
    if (upper->end < lower->end) {
      ++upper;
    } else {
      ++lower;
    }
  }
}

// Finds the axes along which the points with `contact`, or those without it, reach across.
Directions crossed(const ContactMap& map, bool contact) {
  const std::int64_t nx = map.system().nx, ny = map.system().ny;
  const bool joins_x = map.joins_x(), joins_y = map.joins_y();
  const auto inside = [&](std::int64_t x, std::int64_t y) {
    return map.included(y * nx + x) && map.touches(y * nx + x) == contact;
  };

  Clusters clusters;
  std::vector<Stretch> first, before, row;
  for (std::int64_t y = 0; y < ny; ++y, before.swap(row)) {
    row.clear();
    for (std::int64_t x = 0; x < nx; ++x) {
      if (!inside(x, y)) continue;
      const std::int64_t begin = x;
      while (x < nx && inside(x, y)) ++x;
      unsigned sides = 0;
      if (!joins_x) sides |= (begin == 0 ? left : 0) | (x == nx ? right : 0);
      if (!joins_y) sides |= (y == 0 ? top : 0) | (y == ny - 1 ? bottom : 0);
      row.push_back({begin, x, clusters.add(sides)});
    }
    if (joins_x && !row.empty() && row.front().begin == 0 && row.back().end == nx)
      clusters.join(row.back().number, row.front().number, {1, 0});
    join_rows(before, row, {}, clusters);
    if (y == 0) first = row;
  }
  if (joins_y) join_rows(before, first, {0, 1}, clusters);
  return clusters.crossing();
}

}  // namespace

rc_crossing find_crossing(const ContactMap& map) {
  const Directions contact = crossed(map, true), gap = crossed(map, false);
  return {sizeof(rc_crossing), contact.x, contact.y, gap.x, gap.y};
}

}  // namespace rc
