#include "paths.h"

#include <algorithm>
#include <queue>

namespace rc::flow {

namespace {

constexpr Side across_sides[] = {Side::left, Side::right, Side::above, Side::below};

Side opposite(Side side) {
  switch (side) {
    case Side::left:
      return Side::right;
    case Side::right:
      return Side::left;
    case Side::above:
      return Side::below;
    case Side::below:
      return Side::above;
    default:
      return side;
  }
}

struct Frontier {
  double gap;
  std::int32_t cell;
  Side parent;
  bool operator<(const Frontier& other) const { return gap != other.gap ? gap < other.gap : cell > other.cell; }
};

class Search {
 public:
  Search(const Grid& grid, const std::vector<double>& gap) : grid_(grid), gap_(gap) {
    found_.parent.assign(gap.size(), Side::none);
  }

  // Always steps to the highest cell at the border of those reached (Prim): the tree has the widest paths, and the lowest step
  // until the outlet is the constriction.
  void from_inlet(bool until_outlet) {
    for (std::int64_t y = 0; y < grid_.ny; ++y) push(y * grid_.nx, Side::inlet);
    double lowest = infinity;
    std::int64_t place = outside;
    bool arrived = false;
    grow([&](const Frontier& next) {
      if (next.gap < lowest) {
        lowest = next.gap;
        place = next.cell;
      }
      if (arrived || next.cell % grid_.nx + 1 != grid_.nx) return true;
      arrived = true;
      found_.constriction = lowest;
      found_.place = place;
      return !until_outlet;
    });
    if (!until_outlet) keep_if_crossing();
  }

  // Reaches the same cells in any order.
  void flood() {
    const auto reach = [&](std::int64_t i, Side parent) {
      const auto at = static_cast<std::size_t>(i);
      if (!(gap_[at] > 0) || found_.on(i)) return;
      found_.parent[at] = parent;
      found_.order.push_back(static_cast<std::int32_t>(i));
    };
    for (std::int64_t y = 0; y < grid_.ny; ++y) reach(y * grid_.nx, Side::inlet);
    for (std::size_t k = 0; k < found_.order.size(); ++k) {
      if (k % 65536 == 0) stop_if_asked();
      const std::int32_t i = found_.order[k];
      for (const Side side : across_sides)
        if (const std::int64_t other = neighbour(grid_, i, side); other != outside) reach(other, opposite(side));
    }
    keep_if_crossing();
  }

  // Parts that repeat. Each has a winding number at every cell, counted along the tree; it repeats if some edge contradicts it.
  void from_everywhere() {
    std::vector<std::int32_t> wound_x(gap_.size()), wound_y(gap_.size());
    std::size_t begin = 0;
    for (std::int64_t i = 0; i < grid_.size(); ++i) {
      if (found_.on(i)) continue;
      push(i, Side::inlet);
      grow([&](const Frontier& next) {
        const auto at = static_cast<std::size_t>(next.cell);
        if (next.parent == Side::inlet) return true;
        const auto parent = static_cast<std::size_t>(neighbour(grid_, next.cell, next.parent));
        wound_x[at] = wound_x[parent] - winding_x(next.cell, next.parent);
        wound_y[at] = wound_y[parent] - winding_y(next.cell, next.parent);
        return true;
      });
      bool along_x = false, along_y = false;
      for (std::size_t k = begin; k < found_.order.size(); ++k) {
        const std::int64_t cell = found_.order[k];
        for (const Side side : {Side::right, Side::below}) {
          const std::int64_t other = neighbour(grid_, cell, side);
          if (other == outside || !found_.on(other)) continue;
          const auto a = static_cast<std::size_t>(cell), b = static_cast<std::size_t>(other);
          along_x |= wound_x[a] + winding_x(cell, side) != wound_x[b];
          along_y |= wound_y[a] + winding_y(cell, side) != wound_y[b];
        }
      }
      found_.repeats_x |= along_x;
      found_.repeats_y |= along_y;
      if (along_x || along_y) {
        begin = found_.order.size();
      } else {
        left_.insert(left_.end(), found_.order.begin() + static_cast<std::ptrdiff_t>(begin), found_.order.end());
        found_.order.resize(begin);
      }
    }
    for (const std::int32_t cell : left_) found_.parent[static_cast<std::size_t>(cell)] = Side::none;
  }

  Paths take() { return std::move(found_); }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  void push(std::int64_t i, Side parent) {
    const auto at = static_cast<std::size_t>(i);
    if (gap_[at] > 0 && found_.parent[at] == Side::none) border_.push({gap_[at], static_cast<std::int32_t>(i), parent});
  }

  // reached: of each cell; false ends it.
  template <class Reached> void grow(const Reached& reached) {
    for (std::size_t steps = 0; !border_.empty(); ++steps) {
      if (steps % 65536 == 0) stop_if_asked();
      const Frontier next = border_.top();
      border_.pop();
      if (found_.on(next.cell)) continue;
      found_.parent[static_cast<std::size_t>(next.cell)] = next.parent;
      found_.order.push_back(next.cell);
      if (!reached(next)) return;
      for (const Side side : across_sides)
        if (const std::int64_t other = neighbour(grid_, next.cell, side); other != outside) push(other, opposite(side));
    }
  }

  // How many periods the step from a cell across a side goes along x, along y.
  std::int32_t winding_x(std::int64_t i, Side side) const {
    const std::int64_t x = i % grid_.nx;
    return side == Side::right && x + 1 == grid_.nx ? 1 : side == Side::left && x == 0 ? -1 : 0;
  }
  std::int32_t winding_y(std::int64_t i, Side side) const {
    const std::int64_t y = i / grid_.nx;
    return side == Side::below && y + 1 == grid_.ny ? 1 : side == Side::above && y == 0 ? -1 : 0;
  }

  // Leaves the cells that the outlet reaches as well.
  void keep_if_crossing() {
    std::vector<std::uint8_t> crosses(gap_.size());
    std::vector<std::int32_t> stack;
    const auto reach = [&](std::int64_t i) {
      const auto at = static_cast<std::size_t>(i);
      if (!found_.on(i) || crosses[at]) return;
      crosses[at] = 1;
      stack.push_back(static_cast<std::int32_t>(i));
    };
    for (std::int64_t y = 1; y <= grid_.ny; ++y) reach(y * grid_.nx - 1);
    while (!stack.empty()) {
      const std::int64_t i = stack.back();
      stack.pop_back();
      for (const Side side : across_sides)
        if (const std::int64_t other = neighbour(grid_, i, side); other != outside) reach(other);
    }
    std::erase_if(found_.order, [&](std::int32_t i) { return !crosses[static_cast<std::size_t>(i)]; });
    for (std::size_t i = 0; i < crosses.size(); ++i)
      if (!crosses[i]) found_.parent[i] = Side::none;
  }

  const Grid& grid_;
  const std::vector<double>& gap_;
  std::priority_queue<Frontier> border_;
  std::vector<std::int32_t> left_;
  Paths found_;
};

}  // namespace

Paths find_paths(const Grid& grid, const std::vector<double>& gap, Find what) {
  Search search(grid, gap);
  if (grid.cell)
    search.from_everywhere();
  else if (what == Find::cells)
    search.flood();
  else
    search.from_inlet(what == Find::constriction);
  return search.take();
}

}  // namespace rc::flow
