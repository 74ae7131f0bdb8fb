#include "trees/tree_pair.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <roughcontact/plugin.hpp>
#include <utility>
#include <vector>

#include "core/sums.h"

namespace rc {

namespace {

// Fewest blocks worth sharing between threads: where every cell exists, and where only some do.
constexpr std::int64_t least_shared = 16384, least_scattered = 1024;
constexpr std::int64_t chunk = 8192;  // unknowns of a partial sum where not every cell exists

}  // namespace

HaarTreePair::HaarTreePair(Cells cells, const CouplingTable& table, float finest, const Rows& rows)
    : tree_{HaarTree(cells, table, false, finest, rows.ranks()), HaarTree(cells, table, true, finest, rows.ranks())},
      ranks_(rows.ranks()),
      cells_(std::move(cells)),
      unknowns_(ranks_          ? cells_.mx * ranks_->rows()
                : cells_.full() ? cells_.mx * cells_.my
                                : static_cast<std::int64_t>(cells_.x.size())),
      row_(tree_[0].full() ? static_cast<std::size_t>(tree_[0].columns()) : 0) {
  if (!ranks_) return;
  std::int64_t values = 0;
  for (std::size_t rank = 0; rank < tree_[0].whole_values().size(); ++rank) {
    const std::int64_t count = tree_[0].whole_values()[rank] + tree_[1].whole_values()[rank];
    joined_bytes_.push_back(count * static_cast<std::int64_t>(sizeof(float)));
    values += count;
  }
  joined_.resize(static_cast<std::size_t>(values));
  given_.resize(static_cast<std::size_t>(joined_bytes_[static_cast<std::size_t>(ranks_->rank())]) / sizeof(float));
}

void HaarTreePair::place(std::byte* memory) {
  tree_[0].place(memory);
  tree_[1].place(memory + tree_[0].bytes());
}

// The first level above the finest that is too small to be shared: from it on one thread does each tree. Not below the first that
// no ranks share.
std::size_t HaarTreePair::shared_levels() const {
  std::size_t level = std::max<std::size_t>(1, shared_by_ranks());
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

// If not every cell exists: rebuilds the trees over only the unknowns in contact.
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

template <class Value> void HaarTreePair::lend_row(Value* vector) const {
  if (!ranks_ || !tree_[1].shifted_rows(0)) return;
  const std::int64_t columns = tree_[1].columns();
  ranks_->down(vector + unknowns_ - columns, vector - columns, columns, tree_[1].rows_around(0));
}

// Adds what the next rank has found for this rank's last row.
template <class Real> void HaarTreePair::take_back_row(Real* z) {
  const std::int64_t columns = tree_[1].columns();
  Real* const share = row<Real>();
  std::fill_n(share, columns, Real{0});
  ranks_->up(z - columns, share, columns, tree_[1].rows_around(0));
  for (std::int64_t x = 0; x < columns && unknowns_ > 0; ++x) z[unknowns_ - columns + x] += share[x];
}

void HaarTreePair::lend_rows(std::size_t level) {
  HaarTree& tree = tree_[1];
  if (level >= tree.levels() || !tree.shifted_rows(level)) return;
  if (level < shared_by_ranks())
    ranks_->down(tree.last_row(level), tree.row_before(level), tree.row_values(level), tree.rows_around(level));
  else if (tree.rows_around(level))
    std::copy_n(tree.last_row(level), tree.row_values(level), tree.row_before(level));
}

void HaarTreePair::return_rows(std::size_t level) {
  HaarTree& tree = tree_[1];
  if (level >= tree.levels() || !tree.shifted_rows(level)) return;
  if (level < shared_by_ranks())
    ranks_->up(tree.row_before(level), tree.last_row(level), tree.row_values(level), tree.rows_around(level));
  else if (tree.rows_around(level))
    std::copy_n(tree.row_before(level), tree.row_values(level), tree.last_row(level));
}

void HaarTreePair::join_whole_level(bool clear) {
  const auto here = static_cast<std::size_t>(ranks_->rank());
  float* mine = given_.data();
  for (HaarTree& tree : tree_) {
    const auto before =
        std::accumulate(tree.whole_values().begin(), tree.whole_values().begin() + ranks_->rank(), std::int64_t{0});
    mine = std::copy_n(tree.whole_rows() + before, tree.whole_values()[here], mine);
  }
  ranks_->gather(given_.data(), joined_bytes_.data(), joined_.data());
  const float* from = joined_.data();
  std::int64_t at[2] = {0, 0};
  for (std::size_t rank = 0; rank < joined_bytes_.size(); ++rank)
    for (int i = 0; i < 2; ++i) {
      const std::int64_t count = tree_[i].whole_values()[rank];
      std::copy_n(from, count, tree_[i].whole_rows() + at[i]);
      at[i] += count;
      from += count;
    }
  if (!clear) return;
  for (HaarTree& tree : tree_) tree.clear_around_whole_rows();
}

void HaarTreePair::set_up(std::uint8_t* active, float surplus, const rc_team& team) {
  if (!tree_[0].full()) take(active, team);
  lend_row(active);
  on_finest(team,
            [&](HaarTree& tree, std::int64_t part) { tree.solve_finest(part, active - tree.rows_before() * tree.columns()); });
  const std::size_t small = shared_levels();
  for (std::size_t level = 1; level < small; ++level) {
    if (level == shared_by_ranks()) join_whole_level(true);
    lend_rows(level);
    on_level(level, team, [&](HaarTree& tree, std::int64_t part) { tree.solve(level, part); });
  }
  if (small == shared_by_ranks()) join_whole_level(true);
  roughcontact::for_each(team, 2, worth_sharing(0), [&](std::int64_t i, std::int64_t) {
    HaarTree& tree = tree_[i];
    for (std::size_t level = small; level < tree.levels(); ++level) {
      if (i == 1) lend_rows(level);
      for (std::int64_t part = 0; part < tree.parts(level); ++part) tree.solve(level, part);
    }
    tree.solve_top(surplus);
  });
}

template <class Real>
double HaarTreePair::apply(Real* g, const std::uint8_t* active, Real* z, const Real* q, double* level_out, const rc_team& team,
                           HaarSlope<Real>* slope) {
  if (!tree_[0].full()) std::fill_n(z, unknowns_, Real{0});
  if (!g && tree_[0].full()) std::fill_n(row<Real>(), tree_[0].columns(), Real{1});
  const HaarFinestValues<Real> values{active, g, row<Real>(), z, Real{0.5}, false};
  const std::int64_t above = before(1);  // values before the first of this rank's
  const HaarFinestValues<Real> second{active - above, g ? g - above : nullptr, row<Real>(), z - above, Real{0.5}, true};
  if (g) lend_row(g);
  on_finest(team, [&](HaarTree& tree, std::int64_t part) { tree.up_finest(part, &tree == tree_ ? values : second); });
  const std::size_t small = shared_levels();
  for (std::size_t level = 1; level < small; ++level) {
    if (level == shared_by_ranks()) join_whole_level(false);
    lend_rows(level);
    on_level(level, team, [&](HaarTree& tree, std::int64_t part) { tree.up(level, part); });
  }
  if (small == shared_by_ranks()) join_whole_level(false);
  roughcontact::for_each(team, 2, worth_sharing(0), [&](std::int64_t i, std::int64_t) {
    HaarTree& tree = tree_[i];
    for (std::size_t level = small; level < tree.levels(); ++level) {
      if (i == 1) lend_rows(level);
      for (std::int64_t part = 0; part < tree.parts(level); ++part) tree.up(level, part);
    }
  });
  // Shares add up to 1 and differences to 0, so the sum of a tree's z is what comes down from its top.
  const double softness[2] = {tree_[0].softness(), tree_[1].softness()}, both = softness[0] + softness[1];
  const double level_of = level_out && both > 0 ? (softness[0] * tree_[0].load() + softness[1] * tree_[1].load()) / both : 0;
  if (level_out) *level_out = level_of;
  roughcontact::for_each(team, 2, worth_sharing(0), [&](std::int64_t i, std::int64_t) {
    HaarTree& tree = tree_[i];
    tree.turn_top(static_cast<float>(level_of));
    for (std::size_t level = tree.levels(); level-- > small;) {
      for (std::int64_t part = 0; part < tree.parts(level); ++part) tree.down(level, part);
      if (i == 1) return_rows(level);
    }
  });
  for (std::size_t level = small; level-- > 1;) {
    on_level(level, team, [&](HaarTree& tree, std::int64_t part) { tree.down(level, part); });
    return_rows(level);
  }

  const bool parallel = worth_sharing(0);
  const HaarInner<Real> inner = best_haar_inner<Real>();
  std::int64_t piece = chunk;  // unknowns of a partial sum
  if (tree_[0].full()) {
    piece = (ranks_ ? ranks_->piece_rows() : HaarTree::rows_per_part(tree_[0].columns())) * tree_[0].columns();
  } else {
    roughcontact::for_each(team, tree_[0].parts(0), parallel,
                           [&](std::int64_t part, std::int64_t) { tree_[0].down_finest(part, values); });
    roughcontact::for_each(team, tree_[1].parts(0), parallel,
                           [&](std::int64_t part, std::int64_t) { tree_[1].down_finest(part, second); });
    if (!q) return 0;
  }
  const std::int64_t pieces = (unknowns_ + piece - 1) / piece;
  std::vector<HaarProducts> sums(q && !ranks_ ? static_cast<std::size_t>(pieces) : 0);
  const auto add = [&](std::int64_t i) {
    const std::int64_t begin = i * piece, end = std::min(begin + piece, unknowns_);
    if (!q) return;
    HaarProducts sum{.zq = inner(end - begin, z + begin, q + begin, active + begin)};
    if (slope) {
      sum.zg = inner(end - begin, z + begin, g + begin, active + begin);
      sum.tg = inner(end - begin, slope->t + begin, g + begin, active + begin);
    }
    if (ranks_)
      ranks_->put_part(static_cast<std::size_t>(i), sum);
    else
      sums[static_cast<std::size_t>(i)] = sum;
  };
  const bool waits = ranks_ && tree_[1].shifted_rows(0);  // the last piece, for the next rank's share of its last row
  if (waits) std::fill_n(z - tree_[0].columns(), tree_[0].columns(), Real{0});
  roughcontact::for_each(team, pieces, parallel, [&](std::int64_t i, std::int64_t) {
    const std::int64_t begin = i * piece, end = std::min(begin + piece, unknowns_);
    if (tree_[0].full()) {
      tree_[0].down_rows(begin / tree_[0].columns(), end / tree_[0].columns(), values);
      tree_[1].down_rows(begin / tree_[0].columns() - (i == 0 ? tree_[1].rows_before() : 0), end / tree_[0].columns(), second);
    }
    if (!waits || i < pieces - 1) add(i);
  });
  if (waits) {
    take_back_row(z);
    if (pieces > 0) add(pieces - 1);
  }
  if (!q) return 0;
  HaarProducts total;
  const auto sum_up = [&](const HaarProducts& sum) { total = {total.zq + sum.zq, total.zg + sum.zg, total.tg + sum.tg}; };
  if (ranks_)
    ranks_->each_part<HaarProducts>(sum_up);
  else
    std::for_each(sums.begin(), sums.end(), sum_up);
  if (slope) {
    slope->along_z = total.zg;
    slope->along_t = total.tg;
  }
  return total.zq;
}

template double HaarTreePair::apply(float*, const std::uint8_t*, float*, const float*, double*, const rc_team&,
                                    HaarSlope<float>*);
template double HaarTreePair::apply(double*, const std::uint8_t*, double*, const double*, double*, const rc_team&,
                                    HaarSlope<double>*);

}  // namespace rc
