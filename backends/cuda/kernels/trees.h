// The trees of haar-cg as functions of a block's index, in single precision; src/solvers/haar_cg/plain/tree.h explains them.
#pragma once

#include "kernels/passes.h"
#include "trees/tree_shape.h"

namespace rc_cuda {

RC_ANYWHERE inline int integers(float value) { return static_cast<int>(value); }
RC_ANYWHERE inline float numbers(int value) { return static_cast<float>(value); }
#define RC_ALGEBRA RC_ANYWHERE inline
#include "trees/algebra.inc"
#undef RC_ALGEBRA

struct Level {
  Index mx, my;                               // cells
  int merge_x, merge_y;                       // how they join to blocks
  int shift_x, shift_y;                       // 1: the blocks begin one cell earlier
  int around_x, around_y;                     // 1: the first of them begins with the last cell
  Index columns, rows;                        // of blocks
  rc::HaarCouplings coupling;                 // of neighbours
  float *child = nullptr, *parent = nullptr;  // values of cells and blocks; the finest level has no child
  struct Shares* shares = nullptr;            // not on the finest level
  struct Details* details = nullptr;

  RC_ANYWHERE Index blocks() const { return columns * rows; }
};

// As tree/algebra.inc stores them.
struct alignas(8) Shares {
  std::int16_t w[4];
};
struct alignas(4) Details {
  std::uint16_t m[6];
};
// The finest level, for the 16 patterns of cells in the free set.
struct Patterns {
  Solved<float> of[16];
  float above[16];
};

RC_ANYWHERE inline float float_of(std::uint32_t bits) {
  float value;
  __builtin_memcpy(&value, &bits, sizeof value);
  return value;
}
RC_ANYWHERE inline std::uint32_t bits_of(float value) {
  std::uint32_t bits;
  __builtin_memcpy(&bits, &value, sizeof bits);
  return bits;
}

// Where a block's child is among the level's cells; -1: there is none.
RC_ANYWHERE inline Index child_of(const Level& l, Index column, Index row, int c) {
  if ((c % 2 != 0 && !l.merge_x) || (c / 2 != 0 && !l.merge_y)) return -1;
  Index x = l.merge_x ? 2 * column - l.shift_x + c % 2 : column, y = l.merge_y ? 2 * row - l.shift_y + c / 2 : row;
  if (x < 0 && l.around_x) x = l.mx - 1;
  if (y < 0 && l.around_y) y = l.my - 1;
  return x >= 0 && x < l.mx && y >= 0 && y < l.my ? y * l.mx + x : -1;
}
struct Children {
  Index at[4];
};
RC_ANYWHERE inline Children children_of(const Level& l, Index block) {
  const Place place = place_of(block, l.columns);
  Children c;
  for (int i = 0; i < 4; ++i) c.at[i] = child_of(l, place.column, place.row, i);
  return c;
}
template <class T> RC_ANYWHERE void gather(const Children& c, const T* from, float* to) {
  for (int i = 0; i < 4; ++i) to[i] = c.at[i] < 0 ? 0.0F : from ? static_cast<float>(from[c.at[i]]) : 1.0F;
}
RC_ANYWHERE inline int pattern_of(const Children& c, const std::uint8_t* state) {
  int pattern = 0;
  for (int i = 0; i < 4; ++i)
    if (c.at[i] >= 0 && (state[c.at[i]] & in_free_set)) pattern |= 1 << i;
  return pattern;
}

RC_ANYWHERE inline void pack(const Solved<float>& c, Shares& shares, Details& details) {
  for (int i = 0; i < 4; ++i) shares.w[i] = static_cast<std::int16_t>(stored_share(c.w[i]));
  for (int i = 0; i < 6; ++i) details.m[i] = static_cast<std::uint16_t>(stored_half(bits_of(c.m[i])));
}
RC_ANYWHERE inline void unpack(const Shares& shares, float* w) {
  for (int i = 0; i < 4; ++i) w[i] = share_of(static_cast<int>(shares.w[i]));
}
RC_ANYWHERE inline Solved<float> unpacked(const Shares& shares, const Details& details) {
  Solved<float> c;
  unpack(shares, c.w);
  for (int i = 0; i < 6; ++i) c.m[i] = float_of(static_cast<std::uint32_t>(details.m[i]) << 16);
  return c;
}

struct SolveFinest {
  const std::uint8_t* state;
  const Patterns* table;
  RC_ANYWHERE void operator()(const Level& l, Index block) const {
    l.parent[block] = table->above[pattern_of(children_of(l, block), state)];
  }
};
template <class R> struct UpFinest {
  const std::uint8_t* state;
  const Patterns* table;
  const R* g;  // null: 1 everywhere
  RC_ANYWHERE void operator()(const Level& l, Index block) const {
    const Children c = children_of(l, block);
    float load[4];
    gather(c, g, load);
    l.parent[block] = lifted(table->of[pattern_of(c, state)].w, load);
  }
};
struct Solve {
  RC_ANYWHERE void operator()(const Level& l, Index block) const {
    float self[4];
    gather(children_of(l, block), l.child, self);
    Solved<float> c;
    l.parent[block] = solved(l.coupling, self, c);
    pack(c, l.shares[block], l.details[block]);
  }
};
struct Up {
  RC_ANYWHERE void operator()(const Level& l, Index block) const {
    float load[4], w[4];
    gather(children_of(l, block), l.child, load);
    unpack(l.shares[block], w);
    l.parent[block] = lifted(w, load);
  }
};
struct Down {
  RC_ANYWHERE void operator()(const Level& l, Index block) const {
    const Children c = children_of(l, block);
    float load[4], z[4];
    gather(c, l.child, load);
    lowered(unpacked(l.shares[block], l.details[block]), load, l.parent[block], z);
    for (int i = 0; i < 4; ++i)
      if (c.at[i] >= 0) l.child[c.at[i]] = z[i];
  }
};

// One level of both trees.
template <class F> struct OnLevel {
  Level level[2];
  F f;
  RC_ANYWHERE void operator()(Index i) const {
    const Index first = level[0].blocks();
    if (i < first)
      f(level[0], i);
    else
      f(level[1], i - first);
  }
};

// z = the mean of what both trees bring down to a cell.
template <class R> struct DownFinest {
  Level level[2];
  const std::uint8_t* state;
  const Patterns* table;
  const double* level_of_w;
  const R *g, *q;
  R* z;
  RC_ANYWHERE Preconditioned operator()(Index i) const {
    Preconditioned result;
    if (i == 0) result.level = *level_of_w;
    if (!(state[i] & in_free_set)) {
      z[i] = 0;
      return result;
    }
    float value = 0;
    for (int tree = 0; tree < 2; ++tree) {
      const Level& l = level[tree];
      const Place cell = place_of(i, l.mx);
      Index x = cell.column + l.shift_x, y = cell.row + l.shift_y;
      if (x == l.mx && l.around_x) x = 0;
      if (y == l.my && l.around_y) y = 0;
      const Index block = (l.merge_y ? y / 2 : y) * l.columns + (l.merge_x ? x / 2 : x);
      const int own = (l.merge_x ? static_cast<int>(x % 2) : 0) + (l.merge_y ? 2 * static_cast<int>(y % 2) : 0);
      const Children c = children_of(l, block);
      float load[4], out[4];
      gather(c, g, load);
      lowered(table->of[pattern_of(c, state)], load, l.parent[block], out);
      value += 0.5F * (own == 0 ? out[0] : own == 1 ? out[1] : own == 2 ? out[2] : out[3]);
    }
    z[i] = static_cast<R>(value);
    if (q) result.overlap = static_cast<double>(z[i]) * static_cast<double>(q[i]);
    return result;
  }
};

// The levels that one block of threads does, one after the other, and the whole.
struct Summit {
  const Level* tree[2];
  int first, levels[2];  // first: the lowest of these levels
  float* top;            // [2] coupling of the whole with itself
  double* level_of_w;

  RC_ANYWHERE int height() const { return (levels[0] > levels[1] ? levels[0] : levels[1]) - first; }
  RC_ANYWHERE Index blocks(int t, int level) const { return level < first || level >= levels[t] ? 0 : tree[t][level].blocks(); }
  RC_ANYWHERE float& whole(int t) const { return *tree[t][levels[t] - 1].parent; }
  template <class F> RC_ANYWHERE void on(const F& f, const int* level, Index i) const {
    const Index before = blocks(0, level[0]);
    if (i < before)
      f(tree[0][level[0]], i);
    else
      f(tree[1][level[1]], i - before);
  }
};
struct SolveSummit {
  Summit summit;
  float surplus, least_top;
  RC_ANYWHERE int phases() const { return summit.height() + 1; }
  RC_ANYWHERE Index count(int phase) const {
    const int level = summit.first + phase;
    return phase == summit.height() ? 2 : summit.blocks(0, level) + summit.blocks(1, level);
  }
  RC_ANYWHERE void operator()(int phase, Index i) const {
    if (phase < summit.height()) {
      const int level[2] = {summit.first + phase, summit.first + phase};
      return summit.on(Solve{}, level, i);
    }
    const float self = summit.whole(static_cast<int>(i)) - surplus, least = least_top * surplus;
    summit.top[i] = self > least ? self : least;
  }
};
struct ApplySummit {
  Summit summit;
  bool keeps_sum;  // the level of w is taken off, so that the sum of z is 0
  RC_ANYWHERE int phases() const { return 2 * summit.height() + 1; }
  RC_ANYWHERE void levels_of(int phase, int* level) const {
    for (int t = 0; t < 2; ++t)
      level[t] = phase < summit.height() ? summit.first + phase : summit.levels[t] - (phase - summit.height());
  }
  RC_ANYWHERE Index count(int phase) const {
    int level[2];
    levels_of(phase, level);
    return phase == summit.height() ? 1 : summit.blocks(0, level[0]) + summit.blocks(1, level[1]);
  }
  RC_ANYWHERE void operator()(int phase, Index i) const {
    int level[2];
    levels_of(phase, level);
    if (phase < summit.height()) return summit.on(Up{}, level, i);
    if (phase > summit.height()) return summit.on(Down{}, level, i);
    // Shares add up to 1 and differences to 0, so the sum of a tree's z is what comes down from its top.
    double softness[2];
    for (int t = 0; t < 2; ++t) softness[t] = summit.top[t] > 0 ? 1 / static_cast<double>(summit.top[t]) : 0;
    const double both = softness[0] + softness[1];
    const double level_of =
        keeps_sum && both > 0
            ? (softness[0] * static_cast<double>(summit.whole(0)) + softness[1] * static_cast<double>(summit.whole(1))) / both
            : 0;
    *summit.level_of_w = level_of;
    for (int t = 0; t < 2; ++t)
      summit.whole(t) = summit.top[t] > 0 ? (summit.whole(t) - static_cast<float>(level_of)) / summit.top[t] : 0;
  }
};

}  // namespace rc_cuda
