// A multilevel preconditioner for the contact set: a tree of blocks of 2 x 2 cells, each solved exactly for the loads that its
// children carry, with the weights of least energy. Everything is in single precision.
#pragma once

#include <roughcontact/plugin.h>

#include <cstdint>
#include <vector>

namespace rc {

// Influence coefficients at small offsets, enough for the couplings of neighbours on every level.
struct CouplingTable {
  std::int64_t mx, my;
  std::vector<double> k;  // [iy*mx + ix]
  double hx, hy;          // cell size
};

// Where the unknowns lie: all cells of a box, or some of them.
struct Cells {
  std::int64_t mx, my;
  std::vector<std::int32_t> x, y;  // of each unknown, rows in ascending order; empty: every cell

  bool full() const { return x.empty(); }
};

// Values on the levels above the finest, which trees that take turns may share.
struct HaarScratch {
  std::vector<float> g, y;
};

class HaarTree {
 public:
  // `shifted`: the blocks of every second level begin one cell earlier, so that two trees cut the surface at different places.
  HaarTree(const Cells& cells, const CouplingTable& table, bool shifted);

  // active [unknowns]: the contact set. surplus: a constant in every entry of the table that is not in the operator; it only
  // shows at the top of the tree.
  void set_up(const std::uint8_t* active, float surplus, HaarScratch& scratch, const rc_team& team);
  // z = (first ? 0 : z) + scale * M g on the contact set. Returns the sum of z q over it, where q is given.
  template <class Real>
  double apply(const Real* g, const std::uint8_t* active, Real scale, bool first, Real* z, const Real* q, HaarScratch& scratch,
               const rc_team& team) const;

 private:
  // One block: shares of the block's load, and couplings of the differences between children, 01 02 03 12 13 23.
  struct Block {
    float w[4], m[6];
  };
  struct Level {
    std::int64_t mx, my;              // cells of this level
    bool merge_x, merge_y;            // how they join to cells of the next
    std::int64_t shift_x, shift_y;    // 1: the first block is cut
    double kx, ky, kxy;               // couplings of neighbours along x, y, and across
    std::int64_t parents;             // number of blocks
    std::vector<std::int32_t> child;  // [4*parents] where not every cell exists; -1: none
    std::vector<Block> blocks;        // empty on the finest level, where the pattern of the contact set tells
    std::size_t offset;               // of its blocks' values in the scratch
  };

  static Block solved(const Level& level, const double a[4], unsigned pattern, double& parent);
  void link(Level& level, std::vector<std::int32_t>& x, std::vector<std::int32_t>& y) const;
  static std::int64_t items(const Level& level);
  template <class Visit> static void visit_item(const Level& level, std::int64_t item, const Visit& visit);
  template <class Visit> static void visit_all(const Level& level, const rc_team& team, const Visit& visit);

  std::vector<Level> levels_;
  std::vector<Block> finest_;        // [16] by pattern
  std::vector<float> finest_above_;  // [16] self coupling of the parent
  float self_;                       // coefficient of a cell on itself
  std::size_t above_ = 0;            // values above the finest level
  float top_ = 0;                    // self coupling of the whole contact set
};

}  // namespace rc
