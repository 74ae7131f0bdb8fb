#include "solvers/haar_cg/tree_pair.h"

#include <algorithm>
#include <cstring>
#include <roughcontact/plugin.hpp>
#include <utility>
#include <vector>

#include "solvers/haar_cg/threads/pass_loops.h"

namespace rc {

namespace {

// Fewest blocks worth sharing between threads: where every cell exists, and where only some do.
constexpr std::int64_t least_shared = 16384, least_scattered = 1024;
constexpr std::int64_t chunk = 8192;  // unknowns of a partial sum where not every cell exists

}  // namespace

HaarTreePair::HaarTreePair(Cells cells, const CouplingTable& table, float finest)
    : tree_{HaarTree(cells, table, false, finest), HaarTree(cells, table, true, finest)},
      cells_(std::move(cells)),
      unknowns_(cells_.full() ? cells_.mx * cells_.my : static_cast<std::int64_t>(cells_.x.size())) {}

void HaarTreePair::place(std::byte* memory) {
  tree_[0].place(memory);
  tree_[1].place(memory + tree_[0].bytes());
}

// The first level above the finest that is too small to be shared: from it on one thread does each tree.
std::size_t HaarTreePair::shared_levels() const {
  std::size_t level = 1;
  while (level < std::min(tree_[0].levels(), tree_[1].levels()) && worth_sharing(level)) ++level;
  return level;
}

bool HaarTreePair::worth_sharing(std::size_t level) const {
  return tree_[0].blocks(level) >= (tree_[0].full() ? least_shared : least_scattered);
}

// work(tree, part) for all parts of a level of both trees.
template <class Work> void HaarTreePair::on_level(std::size_t level, const rc_team& team, const Work& work) {
  const std::int64_t first = tree_[0].parts(level), all = first + tree_[1].parts(level);
  roughcontact::for_each(team, all, worth_sharing(level), [&](std::int64_t part, std::int64_t) {
    part < first ? work(tree_[0], part) : work(tree_[1], part - first);
  });
}

// The same for the finest level: one thread takes the same unknowns for both trees, one tree after the other.
template <class Work> void HaarTreePair::on_finest(const rc_team& team, const Work& work) {
  const std::int64_t parts[2] = {tree_[0].parts(0), tree_[1].parts(0)};
  const std::int64_t all = std::max(parts[0], parts[1]);
  roughcontact::for_each(team, all, worth_sharing(0), [&](std::int64_t part, std::int64_t) {
    for (int i = 0; i < 2; ++i)
      if (part < parts[i]) work(tree_[i], part);
  });
}

// Where not every cell exists: rebuilds the trees over the unknowns in contact alone.
void HaarTreePair::take(const std::uint8_t* active, const rc_team& team) {
  const auto n = static_cast<std::size_t>(unknowns_);
  if (taken_.size() == n && std::memcmp(taken_.data(), active, n) == 0) return;
  taken_.assign(active, active + n);
  std::vector<std::int32_t> unknowns;
  for (std::size_t i = 0; i < n; ++i)
    if (active[i]) unknowns.push_back(static_cast<std::int32_t>(i));
  roughcontact::for_each(team, 2, static_cast<std::int64_t>(unknowns.size()) >= least_scattered,
                         [&](std::int64_t i, std::int64_t) { tree_[i].take(cells_, unknowns); });
}

void HaarTreePair::set_up(const std::uint8_t* active, float surplus, const rc_team& team) {
  if (!tree_[0].full()) take(active, team);
  on_finest(team, [&](HaarTree& tree, std::int64_t part) { tree.solve_finest(part, active); });
  const std::size_t small = shared_levels();
  for (std::size_t level = 1; level < small; ++level)
    on_level(level, team, [&](HaarTree& tree, std::int64_t part) { tree.solve(level, part); });
  roughcontact::for_each(team, 2, worth_sharing(0), [&](std::int64_t i, std::int64_t) {
    HaarTree& tree = tree_[i];
    for (std::size_t level = small; level < tree.levels(); ++level)
      for (std::int64_t part = 0; part < tree.parts(level); ++part) tree.solve(level, part);
    tree.solve_top(surplus);
  });
}

template <class Real>
double HaarTreePair::apply(const Real* g, const std::uint8_t* active, Real* z, const Real* q, double* level_out,
                           const rc_team& team) {
  if (!tree_[0].full()) std::fill_n(z, unknowns_, Real{0});
  const std::vector<Real> ones(g || !tree_[0].full() ? 0 : static_cast<std::size_t>(tree_[0].columns()), Real{1});
  HaarFinestValues<Real> values{active, g, ones.data(), z, Real{0.5}, false};
  on_finest(team, [&](HaarTree& tree, std::int64_t part) { tree.up_finest(part, values); });
  const std::size_t small = shared_levels();
  for (std::size_t level = 1; level < small; ++level)
    on_level(level, team, [&](HaarTree& tree, std::int64_t part) { tree.up(level, part); });
  roughcontact::for_each(team, 2, worth_sharing(0), [&](std::int64_t i, std::int64_t) {
    HaarTree& tree = tree_[i];
    for (std::size_t level = small; level < tree.levels(); ++level)
      for (std::int64_t part = 0; part < tree.parts(level); ++part) tree.up(level, part);
  });
  // Shares add up to 1 and differences to 0, so the sum of a tree's z is what comes down from its top.
  const double softness[2] = {tree_[0].softness(), tree_[1].softness()}, both = softness[0] + softness[1];
  const double level_of = level_out && both > 0 ? (softness[0] * tree_[0].load() + softness[1] * tree_[1].load()) / both : 0;
  if (level_out) *level_out = level_of;
  roughcontact::for_each(team, 2, worth_sharing(0), [&](std::int64_t i, std::int64_t) {
    HaarTree& tree = tree_[i];
    tree.turn_top(static_cast<float>(level_of));
    for (std::size_t level = tree.levels(); level-- > small;)
      for (std::int64_t part = 0; part < tree.parts(level); ++part) tree.down(level, part);
  });
  for (std::size_t level = small; level-- > 1;)
    on_level(level, team, [&](HaarTree& tree, std::int64_t part) { tree.down(level, part); });

  const bool parallel = worth_sharing(0);
  HaarFinestValues<Real> second = values;
  second.add = true;
  const auto inner = best_haar_loops<Real>().inner;
  std::int64_t piece = chunk;  // unknowns of a partial sum
  if (tree_[0].full()) {
    piece = HaarTree::rows_per_part(tree_[0].columns()) * tree_[0].columns();
  } else {
    roughcontact::for_each(team, tree_[0].parts(0), parallel,
                           [&](std::int64_t part, std::int64_t) { tree_[0].down_finest(part, values); });
    roughcontact::for_each(team, tree_[1].parts(0), parallel,
                           [&](std::int64_t part, std::int64_t) { tree_[1].down_finest(part, second); });
    if (!q) return 0;
  }
  const std::int64_t pieces = (unknowns_ + piece - 1) / piece;
  std::vector<double> sums(q ? static_cast<std::size_t>(pieces) : 0, 0.0);
  roughcontact::for_each(team, pieces, parallel, [&](std::int64_t i, std::int64_t) {
    const std::int64_t begin = i * piece, end = std::min(begin + piece, unknowns_);
    if (tree_[0].full()) {
      tree_[0].down_rows(begin / tree_[0].columns(), end / tree_[0].columns(), values);
      tree_[1].down_rows(begin / tree_[0].columns(), end / tree_[0].columns(), second);
    }
    if (q) sums[static_cast<std::size_t>(i)] = inner(end - begin, z + begin, q + begin, active + begin);
  });
  double total = 0;
  for (const double sum : sums) total += sum;
  return total;
}

template double HaarTreePair::apply(const float*, const std::uint8_t*, float*, const float*, double*, const rc_team&);
template double HaarTreePair::apply(const double*, const std::uint8_t*, double*, const double*, double*, const rc_team&);

}  // namespace rc
