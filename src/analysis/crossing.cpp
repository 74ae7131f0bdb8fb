#include "analysis/crossing.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace rc {

namespace {

constexpr unsigned left = 1, right = 2, top = 4, bottom = 8;  // sides of the grid

// Connected stretches of rows, and the sides of the grid that they touch.
class Clusters {
 public:
  std::size_t add(unsigned sides) {
    nodes_.push_back({nodes_.size(), sides});
    return nodes_.size() - 1;
  }

  void join(std::size_t first, std::size_t second) {
    const std::size_t a = root_of(first), b = root_of(second);
    nodes_[b].parent = a;
    nodes_[a].sides |= nodes_[b].sides;
  }

  bool connects(unsigned sides) const {
    return std::ranges::any_of(nodes_, [&](const Node& node) { return (node.sides & sides) == sides; });
  }

 private:
  struct Node {
    std::size_t parent;
    unsigned sides;  // that a root's stretches touch
  };

  std::size_t root_of(std::size_t node) {
    while (nodes_[node].parent != node) node = nodes_[node].parent = nodes_[nodes_[node].parent].parent;
    return node;
  }

  std::vector<Node> nodes_;
};

struct Stretch {
  std::int64_t begin, end;
  std::size_t number;
};

void join_rows(const std::vector<Stretch>& above, const std::vector<Stretch>& below, Clusters& clusters) {
  auto lower = below.begin();
  for (auto upper = above.begin(); upper != above.end() && lower != below.end();) {
    if (upper->begin < lower->end && lower->begin < upper->end) clusters.join(upper->number, lower->number);
    if (upper->end < lower->end) {
      ++upper;
    } else {
      ++lower;
    }
  }
}

}  // namespace

std::int32_t crossed_axes(const ContactMap& map, bool contact) {
  const std::int64_t nx = map.system().nx, ny = map.system().ny;
  const auto inside = [&](std::int64_t x, std::int64_t y) {
    return map.included(y * nx + x) && map.touches(y * nx + x) == contact;
  };

  Clusters clusters;
  std::vector<std::pair<std::size_t, std::size_t>> around;  // stretches of a row that meet if the grid repeats along x
  std::vector<Stretch> first, before, row;
  for (std::int64_t y = 0; y < ny; ++y, before.swap(row)) {
    row.clear();
    for (std::int64_t x = 0; x < nx; ++x) {
      if (!inside(x, y)) continue;
      const std::int64_t begin = x;
      while (x < nx && inside(x, y)) ++x;
      const unsigned sides = (begin == 0 ? left : 0) | (x == nx ? right : 0) | (y == 0 ? top : 0) | (y == ny - 1 ? bottom : 0);
      row.push_back({begin, x, clusters.add(sides)});
    }
    if (map.joins_x() && !row.empty() && row.front().begin == 0 && row.back().end == nx)
      around.emplace_back(row.front().number, row.back().number);
    join_rows(before, row, clusters);
    if (y == 0) first = row;
  }

  std::int32_t found = RC_CROSSES_NONE;
  {
    Clusters along_y = clusters;
    for (const auto& [begin, end] : around) along_y.join(begin, end);
    if (along_y.connects(top | bottom)) found += RC_CROSSES_Y;
  }
  if (map.joins_y()) join_rows(before, first, clusters);
  if (clusters.connects(left | right)) found += RC_CROSSES_X;
  return found;
}

}  // namespace rc
