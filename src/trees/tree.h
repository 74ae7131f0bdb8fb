// One multilevel tree over the unknowns: src/solvers/haar_cg/plain/tree.h explains it. It computes in single precision.
//
// Ranks that share the grid by rows each have their rows of the first levels, and all rows of the others. Where blocks begin one
// cell earlier, the previous rank's last row of cells is needed: it lies before the first of this rank's rows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/ranks.h"
#include "trees/tree_inputs.h"
#include "trees/tree_loops.h"
#include "trees/tree_shape.h"

namespace rc {

// The vectors that the finest level reads and writes. Where the finest level has a row of the previous rank, they begin with it.
template <class Real> struct HaarFinestValues {
  const std::uint8_t* active;  // [unknowns] the free set
  const Real* g;               // [unknowns]; null: 1 everywhere
  const Real* ones;            // without g: [columns]
  Real* z;                     // [unknowns]
  Real scale;
  bool add;

  const Real* row(std::int64_t at) const { return g ? g + at : ones; }
};

// The work on a level is cut into parts, which may run at the same time.
class HaarTree {
 public:
  // `shifted`: the blocks of every second level begin one cell earlier, so that two trees cut the surface at different places.
  // If every cell of a period exists, the first of these blocks begins with the last cell.
  // `finest`: factor of the differences inside the finest blocks.
  // `ranks`: null, or those that share the cells by rows; then every cell exists.
  HaarTree(const Cells& cells, const CouplingTable& table, bool shifted, float finest, const Ranks* ranks = nullptr);

  // If not every cell exists: rebuilds the tree over some of the unknowns only, in ascending order. Call place() first.
  void take(const Cells& cells, const std::vector<std::int32_t>& unknowns);

  // The tree's values and blocks live in the caller's memory, aligned for floats. After the memory has moved, or others have
  // written to it, solve again from the finest level on.
  std::size_t bytes() const { return size_.values * sizeof(float) + size_.blocks * sizeof(HaarBlocks); }
  void place(std::byte* memory) {
    value_ = reinterpret_cast<float*>(memory);
    block_ = reinterpret_cast<HaarBlocks*>(memory + size_.values * sizeof(float));
  }

  std::size_t levels() const { return levels_.size() - 1; }
  std::int64_t blocks(std::size_t level) const { return levels_[level].parents; }
  std::int64_t parts(std::size_t level) const;
  bool full() const { return full_; }
  std::int64_t columns() const { return levels_.front().mx; }  // of cells
  static std::int64_t rows_per_part(std::int64_t columns);     // of cells

  // The first level that ranks do not share; each rank has computed its rows of values there. 0: they share none.
  std::size_t first_whole() const { return first_whole_; }
  // The values of that level before the first row; the numbers of values of each rank's rows.
  float* whole_rows() { return cells(first_whole_) + levels_[first_whole_].lead_y * levels_[first_whole_].pitch; }
  const std::vector<std::int64_t>& whole_values() const { return whole_values_; }
  void clear_around_whole_rows();
  // Whether blocks of this level begin one row of cells earlier; and the first of them with the last row.
  bool shifted_rows(std::size_t level) const { return levels_[level].shift_y != 0; }
  bool rows_around(std::size_t level) const { return levels_[level].around_y; }
  // Above the finest level: values of the row before the first, and of the last row.
  std::int64_t row_values(std::size_t level) const { return levels_[level].pitch; }
  float* row_before(std::size_t level) { return cells(level); }
  float* last_row(std::size_t level) {
    const Level& l = levels_[level];
    return cells(level) + (l.my - 1 + l.lead_y) * l.pitch;
  }
  std::int64_t rows_before() const { return levels_.front().before; }  // of the finest level: 0 or 1

  // Solves the blocks of each level, from the finest up, then the whole. surplus: by how much every entry of the table exceeds
  // that of the operator; it is taken off at the top.
  void solve_finest(std::int64_t part, const std::uint8_t* active);
  void solve(std::size_t level, std::int64_t part);
  void solve_top(float surplus);
  // Loads go up, pressures come down.
  template <class Real> void up_finest(std::int64_t part, const HaarFinestValues<Real>& values);
  void up(std::size_t level, std::int64_t part);
  double load() { return *cells(levels()); }                   // that has come up to the top
  double softness() const { return top_ > 0 ? 1 / top_ : 0; }  // pressure that a unit load brings down
  void turn_top(float level);                                  // of the loads, which is taken off
  void down(std::size_t level, std::int64_t part);
  template <class Real> void down_finest(std::int64_t part, const HaarFinestValues<Real>& values);  // where not every cell exists
  template <class Real> void down_rows(std::int64_t begin, std::int64_t end, const HaarFinestValues<Real>& values);  // of cells

 private:
  struct Level : HaarTreeLevel {
    std::int64_t parents = 0;             // number of blocks
    std::int64_t groups = 0;              // of eight blocks in a row
    std::int64_t lead_x = 0, lead_y = 0;  // empty cells before the first, so that the first block is whole
    std::int64_t before = 0;              // 1: the row of cells before the first is there, the previous rank's or a period's last
    std::int64_t offset = 0;              // of its rows of blocks among the next level's rows of cells
    std::int64_t pitch = 0, height = 0;   // columns and rows of values of the cells
    std::size_t values = 0, blocks = 0;   // where those of this level begin; not on the finest level
    std::vector<std::int32_t> child{};    // [4*parents] where not every cell exists; -1: none
  };
  struct Size {
    std::size_t values = 0, blocks = 0;
  };
  // Positions of the children of eight blocks, in two rows of 16; -1: none.
  struct Places {
    std::int64_t first[16], second[16];
    // end > 0: every step-th child from begin to end-1 of a row is there; they lie side by side from first[0] or second[0] on.
    std::int64_t begin = 0, end = 0, step = 1;  // step 2: blocks have one cell along x
    // If end > 0: the first child of each row if it is the last cell of a period; -1: none.
    std::int64_t around_first = -1, around_second = -1;

    template <class Value> void gather(const Value* from, Value* to_first, Value* to_second) const;
    template <class Value> void scatter(const Value* from_first, const Value* from_second, Value* to) const;
    // Leaves those that are in begin .. end-1, where all of a row are or none is.
    void keep(std::int64_t from, std::int64_t stop);

   private:
    template <class Value> void gather_row(const Value* from, const std::int64_t* place, std::int64_t around, Value* to) const;
    template <class Value> void scatter_row(const Value* from, const std::int64_t* place, std::int64_t around, Value* to) const;
  };

  void share(const Ranks& ranks);
  void link(Level& level, std::vector<std::int32_t>& x, std::vector<std::int32_t>& y) const;
  Size lay_out();
  void tabulate(float self, float finest);
  bool regular(const Level& level) const { return full_ && level.merge_x && level.merge_y; }
  float* cells(std::size_t level) { return value_ + levels_[level].values; }
  float* above(std::size_t level, std::int64_t row) {
    const Level& next = levels_[level + 1];
    return cells(level + 1) + (levels_[level].offset + row + next.lead_y) * next.pitch + next.lead_x;
  }
  HaarBlocks* blocks_of(std::size_t level, std::int64_t row) {
    return block_ + levels_[level].blocks + static_cast<std::size_t>(row * levels_[level].groups);
  }
  void clear_margins(std::size_t level, std::int64_t row);
  void to_front(std::size_t level, std::int64_t row);
  void to_back(std::size_t level, std::int64_t row);
  bool has_row(std::int64_t y) const;
  std::int64_t row_at(std::int64_t y) const;
  Places places(std::size_t level, std::int64_t row, std::int64_t group) const;
  template <class Visit> void each_row(std::size_t level, std::int64_t part, const Visit& visit) const;
  template <class Run, class Single> void each_group(std::int64_t row, const Run& run, const Single& single) const;
  template <class Real>
  void down_group(std::int64_t row, std::int64_t group, std::int64_t begin, std::int64_t end,
                  const HaarFinestValues<Real>& values);

  bool full_;
  std::size_t first_whole_ = 0;
  std::vector<std::int64_t> whole_rows_, whole_values_;  // of each rank, on that level
  std::vector<Level> levels_;                            // the last is the whole, one cell
  HaarPatterns finest_{};
  HaarRows loops_;
  Size size_;  // of the tree over all unknowns
  float* value_ = nullptr;
  HaarBlocks* block_ = nullptr;
  const float least_top_;
  float top_ = 0;  // self coupling of the whole free set
};

}  // namespace rc
