// The work of a tree on one level.
#include <algorithm>
#include <limits>

#include "trees/tree.h"

namespace rc {

namespace {

constexpr std::int64_t cells_per_part = 32768;
constexpr std::int64_t groups_per_part = 64;  // where not every cell exists

}  // namespace

// The values at the places, 0 if there is none; 1 for each place without `from`.
template <class Value>
void HaarTree::Places::gather_row(const Value* from, const std::int64_t* place, std::int64_t around, Value* to) const {
  if (end == 0) {
    for (int i = 0; i < 16; ++i) {
      const Value value =
          from ? from[std::max<std::int64_t>(place[i], 0)] : Value{1};  // read anyway: no branch is foreseen wrongly
      to[i] = place[i] < 0 ? Value{0} : value;
    }
    return;
  }
  std::fill_n(to, 16, Value{0});
  if (around >= 0) *to = from ? from[around] : Value{1};
  if (*place < 0) return;
  if (!from) {
    for (std::int64_t i = begin; i < end; i += step) to[i] = Value{1};
  } else if (step == 1) {
    std::copy_n(from + *place, end - begin, to + begin);
  } else {
    for (std::int64_t i = 0; i < end / 2; ++i) to[2 * i] = from[*place + i];
  }
}

template <class Value>
void HaarTree::Places::scatter_row(const Value* from, const std::int64_t* place, std::int64_t around, Value* to) const {
  if (end > 0) {
    if (around >= 0) to[around] = *from;
    if (*place < 0) return;
    if (step == 1) std::copy(from + begin, from + end, to + *place);
    for (std::int64_t i = 0; step == 2 && i < end / 2; ++i) to[*place + i] = from[2 * i];
    return;
  }
  for (int i = 0; i < 16; ++i)
    if (place[i] >= 0) to[place[i]] = from[i];
}

template <class Value> void HaarTree::Places::gather(const Value* from, Value* to_first, Value* to_second) const {
  gather_row(from, first, around_first, to_first);
  gather_row(from, second, around_second, to_second);
}

template <class Value> void HaarTree::Places::scatter(const Value* from_first, const Value* from_second, Value* to) const {
  scatter_row(from_first, first, around_first, to);
  scatter_row(from_second, second, around_second, to);
}

void HaarTree::Places::keep(std::int64_t from, std::int64_t stop) {
  const auto keep_one = [&](std::int64_t& place) {
    if (place < from || place >= stop) place = -1;
  };
  for (std::int64_t* const place : {first, second})
    for (int i = 0; i < (end > 0 ? 1 : 16); ++i) keep_one(place[i]);
  keep_one(around_first);
  keep_one(around_second);
}

std::int64_t HaarTree::rows_per_part(std::int64_t columns) { return std::max<std::int64_t>(1, cells_per_part / columns / 2) * 2; }

std::int64_t HaarTree::parts(std::size_t level) const {
  const Level& l = levels_[level];
  if (!full_) return (l.groups + groups_per_part - 1) / groups_per_part;
  const std::int64_t rows = rows_per_part(l.mx) / (l.merge_y ? 2 : 1);
  return (l.rows + rows - 1) / rows;
}

// visit(row, first group, end) for the rows of blocks in a part. Where not every cell exists there is one long row.
template <class Visit> void HaarTree::each_row(std::size_t level, std::int64_t part, const Visit& visit) const {
  const Level& l = levels_[level];
  if (!full_) return visit(std::int64_t{0}, part * groups_per_part, std::min((part + 1) * groups_per_part, l.groups));
  const std::int64_t rows = rows_per_part(l.mx) / (l.merge_y ? 2 : 1);
  for (std::int64_t row = part * rows; row < std::min((part + 1) * rows, l.rows); ++row) visit(row, std::int64_t{0}, l.groups);
}

// Whether the finest level has this row of cells. In a period the last row comes before the first.
bool HaarTree::has_row(std::int64_t y) const {
  const Level& l = levels_.front();
  return y >= -std::max<std::int64_t>(l.before, l.around_y) && y < l.my;
}

std::int64_t HaarTree::row_at(std::int64_t y) const {
  const Level& l = levels_.front();
  return (y < -l.before ? l.my - 1 : y + l.before) * l.mx;
}

// Positions of the children of eight blocks: on the finest level among the unknowns, above it among the level's values.
HaarTree::Places HaarTree::places(std::size_t level, std::int64_t row, std::int64_t group) const {
  const Level& l = levels_[level];
  Places at;
  if (!full_) {
    std::fill_n(at.first, 16, std::int64_t{-1});
    std::fill_n(at.second, 16, std::int64_t{-1});
    for (std::int64_t i = 0; i < std::min<std::int64_t>(8, l.columns - 8 * group); ++i) {
      const std::int32_t* const child = l.child.data() + 4 * (8 * group + i);
      for (std::int64_t c = 0; c < 2; ++c) {
        at.first[2 * i + c] = child[c];
        at.second[2 * i + c] = child[2 + c];
      }
    }
    return at;
  }
  at.step = l.merge_x ? 1 : 2;
  const std::int64_t x = 16 / at.step * group - l.shift_x, y = l.merge_y ? 2 * row - l.shift_y : row;
  // Above the finest level the last cell of a period lies before the first.
  at.begin = group > 0 || (level > 0 && l.around_x) ? 0 : l.shift_x;
  at.end = at.step * std::min(16 / at.step, l.mx - l.around_x - x);
  const auto place = [&](std::int64_t line, std::int64_t& first, std::int64_t& around) {
    const bool there = level == 0 ? has_row(line) : line >= -l.before && line < l.my;
    const std::int64_t start = level == 0 ? row_at(line) : (line + l.lead_y) * l.pitch + l.lead_x;
    first = there ? start + x + at.begin : -1;
    if (there && level == 0 && l.around_x && group == 0) around = start + l.mx - 1;
  };
  place(y, at.first[0], at.around_first);
  at.second[0] = -1;
  if (l.merge_y) place(y + 1, at.second[0], at.around_second);
  return at;
}

// run(first, end) for the groups of a row of the finest level all of whose children exist, single(group) for the others.
template <class Run, class Single> void HaarTree::each_group(std::int64_t row, const Run& run, const Single& single) const {
  const Level& l = levels_.front();
  std::int64_t first = 0, end = 0;
  if (regular(l) && has_row(2 * row - l.shift_y) && has_row(2 * row - l.shift_y + 1)) {
    first = l.shift_x;
    end = std::max(first, (l.mx + l.shift_x - l.around_x) / 16);
    if (end > first) run(first, end);
  }
  for (std::int64_t group = 0; group < l.groups; ++group)
    if (group < first || group >= end) single(group);
}

// Zeroes what lies around the row of values that this level writes: there are no cells.
void HaarTree::clear_margins(std::size_t level, std::int64_t row) {
  if (!full_) return;
  const Level &l = levels_[level], &next = levels_[level + 1];
  float* const values = cells(level + 1);
  float* const line = values + (l.offset + row + next.lead_y) * next.pitch;
  std::fill_n(line, next.lead_x, 0.0F);
  std::fill(line + next.lead_x + 8 * l.groups, line + next.pitch, 0.0F);
  to_front(level + 1, row);
  if (level + 1 == first_whole_) return;
  if (row == 0) std::fill_n(values, next.lead_y * next.pitch, 0.0F);
  if (row == l.rows - 1) std::fill(line + next.pitch, values + next.height * next.pitch, 0.0F);
}

// If cells fill a period: moves the last cell of a row, as the level below writes it, before the first; and, of the row of
// values `line`, back.
void HaarTree::to_front(std::size_t level, std::int64_t row) {
  const Level& l = levels_[level];
  if (!l.around_x) return;
  float* const line = above(level - 1, row) - l.lead_x;
  line[0] = line[l.mx];
  line[l.mx] = 0;
}

void HaarTree::to_back(std::size_t level, std::int64_t line) {
  const Level& l = levels_[level];
  float* const values = cells(level) + line * l.pitch;
  if (l.around_x) values[l.mx] = values[0];
}

void HaarTree::solve_finest(std::int64_t part, const std::uint8_t* active) {
  const HaarFinest<float> finest = best_haar_finest<float>();
  const Level& l = levels_.front();
  each_row(0, part, [&](std::int64_t row, std::int64_t begin, std::int64_t stop) {
    float* const to = above(0, row);
    const auto single = [&](std::int64_t group) {
      const Places at = places(0, row, group);
      std::uint8_t first[16], second[16];
      at.gather(active, first, second);
      finest.solve(1, finest_, first, second, to + 8 * group);
    };
    const auto run = [&](std::int64_t from, std::int64_t end) {
      const std::uint8_t* const in = active + 16 * from - l.shift_x;
      const std::int64_t y = 2 * row - l.shift_y;
      finest.solve(end - from, finest_, in + row_at(y), in + row_at(y + 1), to + 8 * from);
    };
    if (full_) return each_group(row, run, single), clear_margins(0, row);
    for (std::int64_t group = begin; group < stop; ++group) single(group);
  });
}

void HaarTree::solve(std::size_t level, std::int64_t part) {
  const Level& l = levels_[level];
  each_row(level, part, [&](std::int64_t row, std::int64_t begin, std::int64_t stop) {
    float* const to = above(level, row);
    HaarBlocks* const blocks = blocks_of(level, row);
    if (regular(l)) {
      const float* const first = cells(level) + 2 * row * l.pitch;
      loops_.solve(l.groups, l.coupling, first, first + l.pitch, blocks, to);
    } else {
      for (std::int64_t group = begin; group < stop; ++group) {
        const Places at = places(level, row, group);
        float first[16], second[16];
        at.gather(cells(level), first, second);
        loops_.solve(1, l.coupling, first, second, blocks + group, to + 8 * group);
      }
    }
    clear_margins(level, row);
  });
}

void HaarTree::solve_top(float surplus) { top_ = std::max(*cells(levels()) - surplus, least_top_ * surplus); }

template <class Real> void HaarTree::up_finest(std::int64_t part, const HaarFinestValues<Real>& values) {
  const HaarFinest<Real> finest = best_haar_finest<Real>();
  const Level& l = levels_.front();
  each_row(0, part, [&](std::int64_t row, std::int64_t begin, std::int64_t stop) {
    float* const to = above(0, row);
    const auto single = [&](std::int64_t group) {
      const Places at = places(0, row, group);
      std::uint8_t in_first[16], in_second[16];
      Real first[16], second[16];
      at.gather(values.active, in_first, in_second);
      at.gather(values.g, first, second);
      finest.up(1, finest_, in_first, in_second, first, second, to + 8 * group);
    };
    const auto run = [&](std::int64_t from, std::int64_t end) {
      const std::int64_t y = 2 * row - l.shift_y, x = 16 * from - l.shift_x, first = row_at(y) + x, second = row_at(y + 1) + x;
      const std::uint8_t* const in = values.active;
      finest.up(end - from, finest_, in + first, in + second, values.row(first), values.row(second), to + 8 * from);
    };
    if (full_) return each_group(row, run, single), to_front(1, row);
    for (std::int64_t group = begin; group < stop; ++group) single(group);
  });
}

void HaarTree::up(std::size_t level, std::int64_t part) {
  const Level& l = levels_[level];
  each_row(level, part, [&](std::int64_t row, std::int64_t begin, std::int64_t stop) {
    float* const to = above(level, row);
    const HaarBlocks* const blocks = blocks_of(level, row);
    if (regular(l)) {
      const float* const first = cells(level) + 2 * row * l.pitch;
      loops_.up(l.groups, blocks, first, first + l.pitch, to);
      return to_front(level + 1, row);
    }
    for (std::int64_t group = begin; group < stop; ++group) {
      const Places at = places(level, row, group);
      float first[16], second[16];
      at.gather(cells(level), first, second);
      loops_.up(1, blocks + group, first, second, to + 8 * group);
    }
    to_front(level + 1, row);
  });
}

void HaarTree::turn_top(float level) {
  float& whole = *cells(levels());
  whole = top_ > 0 ? (whole - level) / top_ : 0;
}

void HaarTree::down(std::size_t level, std::int64_t part) {
  const Level& l = levels_[level];
  each_row(level, part, [&](std::int64_t row, std::int64_t begin, std::int64_t stop) {
    const float* const from = above(level, row);
    const HaarBlocks* const blocks = blocks_of(level, row);
    if (regular(l)) {
      float* const first = cells(level) + 2 * row * l.pitch;
      loops_.down(l.groups, blocks, first, first + l.pitch, from);
      to_back(level, 2 * row);
      return to_back(level, 2 * row + 1);
    }
    for (std::int64_t group = begin; group < stop; ++group) {
      const Places at = places(level, row, group);
      float first[16], second[16];
      at.gather(cells(level), first, second);
      loops_.down(1, blocks + group, first, second, from + 8 * group);
      at.scatter(first, second, cells(level));
    }
    for (std::int64_t line = l.merge_y ? 2 * row : row; line <= (l.merge_y ? 2 * row + 1 : row); ++line) to_back(level, line);
  });
}

// Eight blocks; writes the pressures of the unknowns begin .. end-1 only.
template <class Real>
void HaarTree::down_group(std::int64_t row, std::int64_t group, std::int64_t begin, std::int64_t end,
                          const HaarFinestValues<Real>& values) {
  Places at = places(0, row, group);
  std::uint8_t in_first[16], in_second[16];
  Real first[16], second[16], z_first[16], z_second[16];
  at.gather(values.active, in_first, in_second);
  at.gather(values.g, first, second);
  at.keep(begin, end);
  at.gather<Real>(values.z, z_first, z_second);
  best_haar_finest<Real>().down(1, finest_, in_first, in_second, first, second, above(0, row) + 8 * group, values.scale,
                                values.add, z_first, z_second);
  at.scatter(z_first, z_second, values.z);
}

template <class Real> void HaarTree::down_rows(std::int64_t begin, std::int64_t end, const HaarFinestValues<Real>& values) {
  const HaarFinest<Real> finest = best_haar_finest<Real>();
  const Level& l = levels_.front();
  const auto block = [&](std::int64_t y) { return l.merge_y ? (y + l.shift_y) / 2 : y; };
  const auto down_row = [&](std::int64_t row) {
    const auto single = [&](std::int64_t group) {
      down_group(row, group, (begin + l.before) * l.mx, (end + l.before) * l.mx, values);
    };
    const auto run = [&](std::int64_t group, std::int64_t stop) {
      const std::int64_t y = 2 * row - l.shift_y, x = 16 * group - l.shift_x, first = row_at(y) + x, second = row_at(y + 1) + x;
      const auto wanted = [&](std::int64_t at) {
        return at >= (begin + l.before) * l.mx && at < (end + l.before) * l.mx ? values.z + at : nullptr;
      };
      const std::uint8_t* const in = values.active;
      finest.down(stop - group, finest_, in + first, in + second, values.row(first), values.row(second),
                  above(0, row) + 8 * group, values.scale, values.add, wanted(first), wanted(second));
    };
    each_group(row, run, single);
  };
  for (std::int64_t row = block(begin); row <= std::min(block(end - 1), l.rows - 1); ++row) down_row(row);
  if (l.around_y && l.before == 0 && begin > 0 && end == l.my) down_row(0);
}

template <class Real> void HaarTree::down_finest(std::int64_t part, const HaarFinestValues<Real>& values) {
  each_row(0, part, [&](std::int64_t row, std::int64_t begin, std::int64_t end) {
    for (std::int64_t group = begin; group < end; ++group)
      down_group(row, group, 0, std::numeric_limits<std::int64_t>::max(), values);
  });
}

#define RC_INSTANTIATE(Real)                                                                    \
  template void HaarTree::up_finest(std::int64_t, const HaarFinestValues<Real>&);               \
  template void HaarTree::down_rows(std::int64_t, std::int64_t, const HaarFinestValues<Real>&); \
  template void HaarTree::down_finest(std::int64_t, const HaarFinestValues<Real>&);
RC_INSTANTIATE(float)
RC_INSTANTIATE(double)

}  // namespace rc
