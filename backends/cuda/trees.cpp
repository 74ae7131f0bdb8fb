#include "trees.h"

#include <algorithm>

#include "runtime/memory.h"

namespace rc_cuda {

namespace {

constexpr Index largest_summit = 64 * 64;  // blocks of its lowest level

void lay_out(Layout& layout, std::vector<Level>& levels) {
  float* child = nullptr;
  bool finest = true;
  for (Level& level : levels) {
    const auto blocks = static_cast<std::size_t>(level.blocks());
    level.child = child;
    child = level.parent = layout.next<float>(blocks);
    if (!finest) {
      level.shares = layout.next<Shares>(blocks);
      level.details = layout.next<Details>(blocks);
    }
    finest = false;
  }
}

}  // namespace

Trees::Trees(Index mx, Index my, const rc::CouplingTable& table) : least_top_(rc::haar_least_top(table)) {
  Layout layout(nullptr);
  for (int tree = 0; tree < 2; ++tree) {
    for (const rc::HaarTreeLevel& from : rc::haar_tree_levels(mx, my, table, tree == 1, true))
      levels_[tree].push_back({from.mx, from.my, from.merge_x, from.merge_y, static_cast<int>(from.shift_x),
                               static_cast<int>(from.shift_y), from.around_x, from.around_y, from.columns, from.rows,
                               from.coupling});
    lay_out(layout, levels_[tree]);
    layout.next<Level>(levels(tree));
  }
  layout.next<Patterns>(1);
  layout.next<float>(2);
  layout.next<double>(1);
  bytes_ = layout.used();
  const auto blocks = [&](int tree) { return levels_[tree][summit_].blocks(); };
  while (summit_ < std::min(levels(0), levels(1)) && std::max(blocks(0), blocks(1)) > largest_summit) ++summit_;
  table_ = patterns(static_cast<float>(table.k[0]));
}

Patterns Trees::patterns(float self) const {
  Patterns table{};
  for (unsigned pattern = 0; pattern < 16; ++pattern) {
    float a[4];
    for (unsigned i = 0; i < 4; ++i) a[i] = pattern >> i & 1U ? self : 0;
    Solved<float> c;
    Shares shares;
    Details details;
    table.above[pattern] = solved(levels_[0].front().coupling, a, c);
    pack(c, shares, details);
    table.of[pattern] = unpacked(shares, details);
  }
  return table;
}

void Trees::place(Device& device, unsigned char* memory) {
  Layout layout(memory);
  for (int tree = 0; tree < 2; ++tree) {
    lay_out(layout, levels_[tree]);
    on_device_[tree] = layout.next<Level>(levels(tree));
    device.upload(on_device_[tree], levels_[tree].data(), levels(tree) * sizeof(Level));
  }
  table_on_device_ = layout.next<Patterns>(1);
  device.upload(table_on_device_, &table_, sizeof table_);
  top_ = layout.next<float>(2);
  level_of_w_ = layout.next<double>(1);
}

TreePasses Trees::passes(bool in_block) const {
  TreePasses result;
  for (int tree = 0; tree < 2; ++tree) result.levels[tree] = in_block ? on_device_[tree] : levels_[tree].data();
  result.summit = {{on_device_[0], on_device_[1]},
                   static_cast<int>(summit_),
                   {static_cast<int>(levels(0)), static_cast<int>(levels(1))},
                   top_,
                   level_of_w_};
  result.table = table_on_device_;
  result.least_top = least_top_;
  return result;
}

}  // namespace rc_cuda
