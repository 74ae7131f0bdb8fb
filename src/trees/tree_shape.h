// How the cells of a box join to blocks on every level of a tree, and the couplings of neighbours there.
#pragma once

#include <cstdint>
#include <vector>

#include "trees/tree_inputs.h"

namespace rc {

// Couplings of neighbours along x, along y, and across corners.
struct HaarCouplings {
  float x, y, xy;
};

constexpr float haar_unit_share = 16384;  // shares of a block's children are stored as whole numbers of 2^-14

struct HaarTreeLevel {
  std::int64_t mx, my;                      // cells of this level
  bool merge_x = false, merge_y = false;    // how they join to blocks, the next level's cells
  std::int64_t shift_x = 0, shift_y = 0;    // 1: the blocks begin one cell earlier
  bool around_x = false, around_y = false;  // of a period: the first block begins with the last cell
  HaarCouplings coupling{};                 // of neighbours
  std::int64_t columns = 0, rows = 0;       // of blocks
};

// The surplus is subtracted from the coupling of the whole with itself; at least this share must remain. Trees with couplings in
// periods can go lower.
inline float haar_least_top(const CouplingTable& table) { return table.nx > 0 ? 0.03F : 0.1F; }

// From the finest level up to the one whose block is the whole. `shifted`: the blocks of every second level begin one cell
// earlier, so that two trees cut the surface at different places. `around`: where cells fill a period, with its last cell.
std::vector<HaarTreeLevel> haar_tree_levels(std::int64_t mx, std::int64_t my, const CouplingTable& table, bool shifted,
                                            bool around);

}  // namespace rc
