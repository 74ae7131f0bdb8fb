#include "trees/tree.h"

#include <algorithm>
#include <cstring>

namespace rc {

// Joins the cells at the places (x, y) to blocks. x and y become the places of the blocks.
void HaarTree::link(Level& level, std::vector<std::int32_t>& x, std::vector<std::int32_t>& y) const {
  std::vector<std::int32_t> px, py;
  level.child.clear();
  const auto column = [&](std::size_t i) { return level.merge_x ? (x[i] + level.shift_x) / 2 : std::int64_t{x[i]}; };
  const auto row = [&](std::size_t i) { return level.merge_y ? (y[i] + level.shift_y) / 2 : std::int64_t{y[i]}; };
  // A row of blocks has up to two rows of cells, which follow each other. Each is in ascending order, so the two are merged.
  for (std::size_t begin = 0; begin < x.size();) {
    const std::int64_t parent_row = row(begin);
    std::size_t middle = begin;
    while (middle < x.size() && y[middle] == y[begin]) ++middle;
    std::size_t end = middle;
    while (end < x.size() && row(end) == parent_row) ++end;
    std::size_t upper = begin, lower = middle;
    while (upper < middle || lower < end) {
      const bool both = upper < middle && lower < end;
      const std::int64_t parent_column = both             ? std::min(column(upper), column(lower))
                                         : upper < middle ? column(upper)
                                                          : column(lower);
      const std::size_t at = level.child.size();
      level.child.insert(level.child.end(), 4, -1);
      const auto take = [&](std::size_t& i, std::size_t limit) {
        for (; i < limit && column(i) == parent_column; ++i) {
          const bool right = level.merge_x && (x[i] + level.shift_x) % 2 != 0,
                     below = level.merge_y && (y[i] + level.shift_y) % 2 != 0;
          level.child[at + (right ? 1 : 0) + (below ? 2 : 0)] = static_cast<std::int32_t>(i);
        }
      };
      take(upper, middle);
      take(lower, end);
      px.push_back(static_cast<std::int32_t>(parent_column));
      py.push_back(static_cast<std::int32_t>(parent_row));
    }
    begin = end;
  }
  x = std::move(px);
  y = std::move(py);
  level.parents = static_cast<std::int64_t>(x.size());
}

HaarTree::HaarTree(const Cells& cells, const CouplingTable& table, bool shifted, float finest, const Ranks* ranks)
    : full_(cells.full()), loops_(best_haar_rows()), least_top_(haar_least_top(table)) {
  std::vector<std::int32_t> x = cells.x, y = cells.y;
  for (const HaarTreeLevel& shape : haar_tree_levels(cells.mx, cells.my, table, shifted, full_)) {
    Level level{shape};
    level.parents = shape.columns * shape.rows;
    level.before = level.around_y && !levels_.empty();
    if (!full_) {
      link(level, x, y);
      level.rows = 1;
    }
    levels_.push_back(std::move(level));
  }
  levels_.push_back({{.mx = 1, .my = 1}});
  if (ranks) share(*ranks);
  size_ = lay_out();
  for (const std::int64_t rows : whole_rows_) whole_values_.push_back(rows * levels_[first_whole_].pitch);
  tabulate(static_cast<float>(table.k[0]), finest);
}

// A rank's rows begin at a multiple of 2^halvings, so their number is even on so many levels but for the last rank's.
void HaarTree::share(const Ranks& ranks) {
  std::int64_t first = ranks.first_row(), rows = ranks.rows();
  int merges = 0;
  for (std::size_t l = 0; l + 1 < levels_.size(); ++l) {
    Level& level = levels_[l];
    if (level.merge_y && merges == ranks.halvings()) break;
    merges += level.merge_y;
    level.my = rows;
    level.before = level.shift_y != 0 && rows > 0 && (first > 0 || level.around_y);
    if (level.merge_y) {
      rows = rows == 0 ? 0 : ranks.has_last_row() && !level.around_y ? (rows + level.shift_y + 1) / 2 : rows / 2;
      first /= 2;
    }
    level.rows = rows;
    level.parents = rows * level.columns;
    first_whole_ = l + 1;
  }
  levels_[first_whole_ - 1].offset = first;
  for (std::int64_t rank = 0; rank < ranks.size(); ++rank) {
    const std::int64_t begin = ranks.first()[static_cast<std::size_t>(rank)], end = begin + ranks.rows_of(rank);
    const bool last = end > begin && end == ranks.all_rows();
    whole_rows_.push_back(last ? levels_[first_whole_].my - (begin >> merges) : (end - begin) >> merges);
  }
}

// Clears the cells before and after the rows of all ranks; inside the rows each rank has cleared its own.
void HaarTree::clear_around_whole_rows() {
  const Level& whole = levels_[first_whole_];
  float* const values = cells(first_whole_);
  std::fill_n(values, whole.lead_y * whole.pitch, 0.0F);
  std::fill(values + (whole.lead_y + whole.my) * whole.pitch, values + whole.height * whole.pitch, 0.0F);
}

void HaarTree::take(const Cells& cells, const std::vector<std::int32_t>& unknowns) {
  std::vector<std::int32_t> x, y;
  x.reserve(unknowns.size());
  y.reserve(unknowns.size());
  for (const std::int32_t unknown : unknowns) {
    x.push_back(cells.x[static_cast<std::size_t>(unknown)]);
    y.push_back(cells.y[static_cast<std::size_t>(unknown)]);
  }
  for (std::size_t l = 0; l + 1 < levels_.size(); ++l) link(levels_[l], x, y);
  for (std::int32_t& child : levels_.front().child)
    if (child >= 0) child = unknowns[static_cast<std::size_t>(child)];
  lay_out();
  if (unknowns.empty()) *this->cells(levels()) = 0;
}

// A row of values begins with the empty cells of a shift, and is long enough for whole groups of blocks to be read and written.
HaarTree::Size HaarTree::lay_out() {
  Size size;
  std::int64_t written = 0;  // values in a row of the level's cells, as the level below writes them
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    Level& level = levels_[l];
    if (!full_) level.columns = level.parents;
    level.groups = (level.columns + 7) / 8;
    level.lead_x = full_ ? level.shift_x : 0;
    level.lead_y = full_ ? level.shift_y : 0;
    if (l > 0) {
      level.pitch = std::max(level.lead_x + written, full_ ? 16 * level.groups : 0);
      level.height = !full_ ? 1 : std::max(level.merge_y ? 2 * level.rows : level.my, level.my + level.lead_y);
      level.values = size.values;
      size.values += static_cast<std::size_t>(level.pitch * level.height);
      level.blocks = size.blocks;
      size.blocks += static_cast<std::size_t>(level.rows * level.groups);
    }
    written = 8 * level.groups;
  }
  return size;
}

void HaarTree::tabulate(float self, float finest) {
  float first[32], second[32];  // children of 16 blocks, one block for each pattern
  for (unsigned pattern = 0; pattern < 16; ++pattern)
    for (unsigned i = 0; i < 4; ++i) {
      float* const row = i < 2 ? first : second;
      row[2 * pattern + i % 2] = pattern >> i & 1U ? self : 0;
    }
  HaarBlocks blocks[2];
  loops_.solve(2, levels_.front().coupling, first, second, blocks, finest_.above);
  for (std::size_t pattern = 0; pattern < 16; ++pattern) {
    const HaarBlocks& from = blocks[pattern / 8];
    for (std::size_t i = 0; i < 4; ++i) finest_.w[i][pattern] = static_cast<float>(from.w[i][pattern % 8]) / haar_unit_share;
    for (std::size_t i = 0; i < 6; ++i) {
      const std::uint32_t bits = std::uint32_t{from.m[i][pattern % 8]} << 16;
      float difference;
      std::memcpy(&difference, &bits, sizeof bits);
      finest_.m[i][pattern] = finest * difference;
    }
  }
}

}  // namespace rc
