// The work of a tree on one level.
#include <algorithm>
#include <limits>

#include "solvers/haar_cg/tree.h"

namespace rc {

namespace {

constexpr std::int64_t cells_per_part = 32768;
constexpr std::int64_t groups_per_part = 64;  // where not every cell exists

}  // namespace

// The values at the places, 0 where there is none; 1 for each place without `from`.
template <class Value> void HaarTree::Places::gather_row(const Value* from, const std::int64_t* place, Value* to) const {
  if (end == 0) {
    for (int i = 0; i < 16; ++i) {
      const Value value =
          from ? from[std::max<std::int64_t>(place[i], 0)] : Value{1};  // read anyway: no branch is foreseen wrongly
      to[i] = place[i] < 0 ? Value{0} : value;
    }
    return;
  }
  std::fill_n(to, 16, Value{0});
  if (*place < 0) return;
  if (from)
    std::copy_n(from + *place, end - begin, to + begin);
  else
    std::fill(to + begin, to + end, Value{1});
}

template <class Value> void HaarTree::Places::scatter_row(const Value* from, const std::int64_t* place, Value* to) const {
  if (end > 0) {
    if (*place >= 0) std::copy(from + begin, from + end, to + *place);
    return;
  }
  for (int i = 0; i < 16; ++i)
    if (place[i] >= 0) to[place[i]] = from[i];
}

template <class Value> void HaarTree::Places::gather(const Value* from, Value* to_first, Value* to_second) const {
  gather_row(from, first, to_first);
  gather_row(from, second, to_second);
}

template <class Value> void HaarTree::Places::scatter(const Value* from_first, const Value* from_second, Value* to) const {
  scatter_row(from_first, first, to);
  scatter_row(from_second, second, to);
}

void HaarTree::Places::keep(std::int64_t from, std::int64_t stop) {
  for (std::int64_t* const place : {first, second})
    for (int i = 0; i < (end > 0 ? 1 : 16); ++i)
      if (place[i] < from || place[i] >= stop) place[i] = -1;
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

// Where the children of eight blocks are: on the finest level among the unknowns, above it among the level's values.
HaarTree::Places HaarTree::places(std::size_t level, std::int64_t row, std::int64_t group) const {
  const Level& l = levels_[level];
  Places at;
  if (level == 0 && regular(l)) {
    const std::int64_t x = 16 * group - l.shift_x, y = 2 * row - l.shift_y;
    at.begin = std::max<std::int64_t>(0, -x);
    at.end = std::min<std::int64_t>(16, l.mx - x);
    at.first[0] = y >= -l.before ? (y + l.before) * l.mx + x + at.begin : -1;
    at.second[0] = y + 1 < l.my ? (y + 1 + l.before) * l.mx + x + at.begin : -1;
    return at;
  }
  std::fill_n(at.first, 16, std::int64_t{-1});
  std::fill_n(at.second, 16, std::int64_t{-1});
  const std::int64_t pitch = level == 0 ? l.mx : l.pitch, lead_x = level == 0 ? 0 : l.lead_x,
                     lead_y = level == 0 ? l.before : l.lead_y;
  for (std::int64_t i = 0; i < std::min<std::int64_t>(8, l.columns - 8 * group); ++i) {
    const std::int64_t block = 8 * group + i;
    for (std::int64_t c = 0; c < 4; ++c) {
      std::int64_t* const line = c < 2 ? at.first : at.second;
      std::int64_t& place = line[2 * i + c % 2];
      if (!full_) {
        place = l.child[static_cast<std::size_t>(4 * block + c)];
        continue;
      }
      if ((c % 2 != 0 && !l.merge_x) || (c / 2 != 0 && !l.merge_y)) continue;
      const std::int64_t x = l.merge_x ? 2 * block - l.shift_x + c % 2 : block, y = l.merge_y ? 2 * row - l.shift_y + c / 2 : row;
      if (x >= 0 && x < l.mx && y >= -l.before && y < l.my) place = (y + lead_y) * pitch + x + lead_x;
    }
  }
  return at;
}

// run(first, end) for the groups of a row of the finest level all of whose children exist, single(group) for the others.
template <class Run, class Single> void HaarTree::each_group(std::int64_t row, const Run& run, const Single& single) const {
  const Level& l = levels_.front();
  std::int64_t first = 0, end = 0;
  if (regular(l) && 2 * row - l.shift_y >= -l.before && 2 * row - l.shift_y + 1 < l.my) {
    first = l.shift_x;
    end = std::max(first, (l.mx + l.shift_x) / 16);
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
  if (level + 1 == first_whole_) return;
  if (row == 0) std::fill_n(values, next.lead_y * next.pitch, 0.0F);
  if (row == l.rows - 1) std::fill(line + next.pitch, values + next.height * next.pitch, 0.0F);
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
      const std::uint8_t* const in = active + (2 * row - l.shift_y + l.before) * l.mx + 16 * from - l.shift_x;
      finest.solve(end - from, finest_, in, in + l.mx, to + 8 * from);
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
      const std::int64_t at = (2 * row - l.shift_y + l.before) * l.mx + 16 * from - l.shift_x;
      const std::uint8_t* const in = values.active + at;
      finest.up(end - from, finest_, in, in + l.mx, values.row(at), values.row(at + l.mx), to + 8 * from);
    };
    if (full_) return each_group(row, run, single);
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
      return loops_.up(l.groups, blocks, first, first + l.pitch, to);
    }
    for (std::int64_t group = begin; group < stop; ++group) {
      const Places at = places(level, row, group);
      float first[16], second[16];
      at.gather(cells(level), first, second);
      loops_.up(1, blocks + group, first, second, to + 8 * group);
    }
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
      return loops_.down(l.groups, blocks, first, first + l.pitch, from);
    }
    for (std::int64_t group = begin; group < stop; ++group) {
      const Places at = places(level, row, group);
      float first[16], second[16];
      at.gather(cells(level), first, second);
      loops_.down(1, blocks + group, first, second, from + 8 * group);
      at.scatter(first, second, cells(level));
    }
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
  for (std::int64_t row = block(begin); row <= std::min(block(end - 1), l.rows - 1); ++row) {
    const auto single = [&](std::int64_t group) {
      down_group(row, group, (begin + l.before) * l.mx, (end + l.before) * l.mx, values);
    };
    const auto run = [&](std::int64_t group, std::int64_t stop) {
      const std::int64_t y = 2 * row - l.shift_y, at = (y + l.before) * l.mx + 16 * group - l.shift_x;
      const auto wanted = [&](std::int64_t of) { return of >= begin && of < end ? values.z + at + (of - y) * l.mx : nullptr; };
      const std::uint8_t* const in = values.active + at;
      finest.down(stop - group, finest_, in, in + l.mx, values.row(at), values.row(at + l.mx), above(0, row) + 8 * group,
                  values.scale, values.add, wanted(y), wanted(y + 1));
    };
    each_group(row, run, single);
  }
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
