#include "paths.h"

#include <algorithm>
#include <array>
#include <bit>
#include <queue>
#include <utility>

namespace rc::flow {

namespace {

constexpr std::pair<Side, Side> sides_and_opposites[] = {
    {Side::left, Side::right}, {Side::right, Side::left}, {Side::above, Side::below}, {Side::below, Side::above}};

// Cells that wait, by height: in four levels an octave, each in order of arrival. That is a tree of the widest paths but for the
// width of a level, in linear time.
class Border {
 public:
  void push(std::int32_t cell, double gap) {
    const std::size_t level = level_of(gap);
    cells_[level].push_back(cell);
    highest_ = std::min(highest_, level);
  }
  // Takes a cell of the highest level; returns `outside` if no cell waits.
  std::int64_t pop() {
    for (; highest_ < cells_.size(); ++highest_) {
      if (std::size_t& next = next_[highest_]; next < cells_[highest_].size()) return cells_[highest_][next++];
      cells_[highest_].clear();
      next_[highest_] = 0;
    }
    return outside;
  }

 private:
  static constexpr std::size_t levels = 160;
  static std::size_t level_of(double gap) {
    constexpr int drop = 50;  // bits of the fraction
    const std::uint64_t one = std::bit_cast<std::uint64_t>(1.0) >> drop, bits = std::bit_cast<std::uint64_t>(gap) >> drop;
    return bits < one ? static_cast<std::size_t>(std::min<std::uint64_t>(one - bits, levels - 1)) : 0;
  }

  std::array<std::vector<std::int32_t>, levels> cells_;
  std::array<std::size_t, levels> next_{};
  std::size_t highest_ = levels;
};

class Search {
 public:
  Search(const Grid& grid, const std::vector<double>& gap) : grid_(grid), gap_(gap) {
    found_.parent.assign(gap.size(), Side::none);
  }

  // The lowest step until the outlet if each is to the highest cell at the border of those reached.
  void constriction() {
    std::priority_queue<std::pair<double, std::int64_t>> lower;
    std::vector<std::int64_t> ready;
    double lowest = std::numeric_limits<double>::infinity();
    std::int64_t place = outside;
    const auto reach = [&](std::int64_t i, Side parent) {
      const double g = gap_[static_cast<std::size_t>(i)];
      if (!(g > 0) || found_.on(i)) return;
      found_.parent[static_cast<std::size_t>(i)] = parent;
      if (g < lowest)
        lower.emplace(g, -i);
      else
        ready.push_back(i);
    };
    for (std::int64_t y = 0; y < grid_.ny; ++y) reach(y * grid_.nx, Side::inlet);
    for (std::size_t steps = 0;; ++steps) {
      if (steps % 65536 == 0) stop_if_asked();
      if (ready.empty()) {
        if (lower.empty()) return;
        lowest = lower.top().first;
        place = -lower.top().second;
        ready.push_back(place);
        lower.pop();
      }
      const std::int64_t i = ready.back();
      ready.pop_back();
      if (i % grid_.nx + 1 == grid_.nx) {
        found_.constriction = lowest;
        found_.place = place;
        return;
      }
      each_neighbour(i, reach);
    }
  }

  void from_inlet() {
    for (std::int64_t y = 0; y < grid_.ny; ++y) reach(y * grid_.nx, Side::inlet);
    grow();
    keep_if_crossing();
  }

  // Parts that repeat. Each has a winding number at every cell, counted along the tree; it repeats if some edge contradicts it.
  void from_everywhere() {
    std::vector<std::int32_t> wound_x(gap_.size()), wound_y(gap_.size());
    std::size_t begin = 0;
    for (std::int64_t i = 0; i < grid_.size(); ++i) {
      if (found_.on(i)) continue;
      reach(i, Side::inlet);
      grow();
      for (std::size_t k = begin; k < found_.order.size(); ++k) {
        const std::int64_t cell = found_.order[k];
        const auto at = static_cast<std::size_t>(cell);
        const Side side = found_.parent[at];
        const std::int64_t parent = neighbour(grid_, cell, side);
        if (parent == outside) continue;
        wound_x[at] = wound_x[static_cast<std::size_t>(parent)] - winding_x(cell, side);
        wound_y[at] = wound_y[static_cast<std::size_t>(parent)] - winding_y(cell, side);
      }
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
  template <class Visit> void each_neighbour(std::int64_t i, const Visit& visit) const {
    for (const auto& [side, opposite] : sides_and_opposites)
      if (const std::int64_t other = neighbour(grid_, i, side); other != outside) visit(other, opposite);
  }
  void reach(std::int64_t i, Side parent) {
    const auto at = static_cast<std::size_t>(i);
    if (!(gap_[at] > 0) || found_.on(i)) return;
    found_.parent[at] = parent;
    border_.push(static_cast<std::int32_t>(i), gap_[at]);
  }
  void grow() {
    for (std::int64_t i; (i = border_.pop()) != outside;) {
      if (found_.order.size() % 65536 == 0) stop_if_asked();
      found_.order.push_back(static_cast<std::int32_t>(i));
      each_neighbour(i, [&](std::int64_t other, Side parent) { reach(other, parent); });
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
    const auto reach_back = [&](std::int64_t i) {
      const auto at = static_cast<std::size_t>(i);
      if (!found_.on(i) || crosses[at]) return;
      crosses[at] = 1;
      stack.push_back(static_cast<std::int32_t>(i));
    };
    for (std::int64_t y = 1; y <= grid_.ny; ++y) reach_back(y * grid_.nx - 1);
    while (!stack.empty()) {
      const std::int64_t i = stack.back();
      stack.pop_back();
      each_neighbour(i, [&](std::int64_t other, Side) { reach_back(other); });
    }
    std::erase_if(found_.order, [&](std::int32_t i) { return !crosses[static_cast<std::size_t>(i)]; });
    for (std::size_t i = 0; i < crosses.size(); ++i)
      if (!crosses[i]) found_.parent[i] = Side::none;
  }

  const Grid& grid_;
  const std::vector<double>& gap_;
  Border border_;
  std::vector<std::int32_t> left_;
  Paths found_;
};

}  // namespace

Paths find_paths(const Grid& grid, const std::vector<double>& gap, Find what) {
  Search search(grid, gap);
  if (what == Find::constriction)
    search.constriction();
  else if (grid.cell)
    search.from_everywhere();
  else
    search.from_inlet();
  return search.take();
}

}  // namespace rc::flow
