// A multilevel preconditioner for the contact set: a tree of blocks of 2 x 2 cells, each solved exactly for the loads that its
// children carry, with the weights of least energy.
#pragma once

#include <cstdint>
#include <vector>

namespace rc {

// Influence coefficients at small offsets, enough for the couplings of neighbours on every level.
struct CouplingTable {
  std::int64_t mx, my;
  std::vector<double> k;  // [iy*mx + ix]
  double hx, hy;          // cell size
};

class HaarTree {
 public:
  // Over a box of mx x my cells. `shifted`: the blocks of every second level begin one cell earlier, so that two trees cut the
  // surface at different places.
  HaarTree(std::int64_t mx, std::int64_t my, const CouplingTable& table, bool shifted);

  // active [mx*my]: the contact set.
  void set_up(const std::vector<char>& active);
  // y += scale * M g on the contact set; g is 0 elsewhere.
  void apply_add(const std::vector<double>& g, double scale, std::vector<double>& y);

 private:
  struct Level {
    std::int64_t mx, my;            // cells of this level
    bool merge_x, merge_y;          // how they join to cells of the next
    std::int64_t shift_x, shift_y;  // 1: the first block is cut
    double kx, ky, kxy;             // couplings of neighbours along x, y, and across
    std::vector<double> a;          // self coupling of what a cell carries; 0: no contact in it
    std::vector<double> w;          // share of its block's load
    std::vector<double> g, y;       // of the sweep; empty on the finest level
  };
  struct Block;

  template <class Visit> void for_blocks(std::size_t level, const Visit& visit);

  std::vector<Level> levels_;
  double self_;  // coefficient of a cell on itself
};

}  // namespace rc
