// The paths through a gap: which cells they reach, a tree of the widest ones, and the narrowest place of the best one.
#pragma once

#include <vector>

#include "network.h"

namespace rc::flow {

struct Paths {
  std::vector<std::int32_t> order;  // cells on a path from inlet to outlet, or of a part that repeats; each after its parent
  std::vector<Side> parent;         // where the parent of each of them lies; inlet: a root. none: the cell is on no path
  double constriction = 0;          // of the best path
  std::int64_t place = outside;
  bool repeats_x = false, repeats_y = false;  // of a cell: some path ends one period further along x, along y

  bool any() const { return !order.empty(); }
  bool on(std::int64_t i) const { return parent[static_cast<std::size_t>(i)] != Side::none; }
};

// Cells and tree, or with inlet and outlet the constriction and its place.
enum class Find { tree, constriction };

// gap: of all cells, 0: closed.
Paths find_paths(const Grid& grid, const std::vector<double>& gap, Find what = Find::tree);

}  // namespace rc::flow
