// Hoshen & Kopelman (Physical Review B 14 (1976) 3438), with runs in place of cells: each row is cut into runs of cells in
// contact, and runs that touch are joined, by union by size with path halving.
#include "analysis/patches.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "core/array.h"
#include "core/error.h"

namespace rc {

namespace {

using Index = std::size_t;

class Sets {
 public:
  explicit Sets(Index n) : parent_(n), size_(n, 1) { std::iota(parent_.begin(), parent_.end(), Index{0}); }
  Index root(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(Index a, Index b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    if (size_[a] < size_[b]) std::swap(a, b);
    parent_[b] = a;
    size_[a] += size_[b];
  }

 private:
  std::vector<Index> parent_, size_;
};

// Columns begin .. end-1 of a row.
struct Run {
  std::int64_t begin, end;
};

class Runs {
 public:
  explicit Runs(const ContactMap& map) : nx_(map.system().nx) {
    first_.reserve(static_cast<Index>(map.system().ny) + 1);
    for (std::int64_t iy = 0; iy < map.system().ny; ++iy) {
      first_.push_back(runs_.size());
      for (std::int64_t ix = 0; ix < nx_; ++ix) {
        if (!map.touches(iy * nx_ + ix)) continue;
        const std::int64_t begin = ix;
        while (ix < nx_ && map.touches(iy * nx_ + ix)) ++ix;
        runs_.push_back({begin, ix});
      }
    }
    first_.push_back(runs_.size());
  }

  Index count() const { return runs_.size(); }
  Index rows() const { return first_.size() - 1; }
  Index begin(Index row) const { return first_[row]; }
  Index end(Index row) const { return first_[row + 1]; }
  const Run& operator[](Index run) const { return runs_[run]; }

  // Joins runs of two neighbouring rows that touch. reach 1: across corners as well.
  void join_rows(Index a_row, Index b_row, std::int64_t reach, Sets& sets) const {
    Index a = begin(a_row), b = begin(b_row);
    while (a < end(a_row) && b < end(b_row)) {
      if (runs_[a].begin < runs_[b].end + reach && runs_[b].begin < runs_[a].end + reach) sets.join(a, b);
      if (runs_[a].end < runs_[b].end)
        ++a;
      else
        ++b;
    }
  }

  // Joins the last run of row a to the first of row b, if both reach the side of the grid. a_row may be b_row.
  void join_sides(Index a_row, Index b_row, Sets& sets) const {
    if (begin(a_row) == end(a_row) || begin(b_row) == end(b_row)) return;
    if (runs_[end(a_row) - 1].end == nx_ && runs_[begin(b_row)].begin == 0) sets.join(end(a_row) - 1, begin(b_row));
  }

 private:
  std::int64_t nx_;
  std::vector<Run> runs_;
  std::vector<Index> first_;  // the first run of each row; at the end the number of runs
};

Sets joined(const Runs& runs, bool corners, const ContactMap& map) {
  Sets sets(runs.count());
  const auto neighbours = [&](Index a, Index b) {
    runs.join_rows(a, b, corners ? 1 : 0, sets);
    if (!map.joins_x() || !corners) return;
    runs.join_sides(a, b, sets);
    runs.join_sides(b, a, sets);
  };
  for (Index row = 0; row < runs.rows(); ++row) {
    if (row > 0) neighbours(row - 1, row);
    if (map.joins_x()) runs.join_sides(row, row, sets);
  }
  if (map.joins_y()) neighbours(runs.rows() - 1, 0);
  return sets;
}

struct Patch {
  std::int64_t cells = 0, peak = 0;
  Edges edges;
  double sum = 0, max = 0;
};

template <class Get> void give(const rc_array& to, std::int64_t room, const std::vector<Patch>& patches, const Get& get) {
  using Value = decltype(get(patches[0]));
  if (!to.data) return;
  const Index n = std::min(static_cast<Index>(room), patches.size());
  for (Index k = 0; k < n; ++k) values_of<Value>(to)[k] = get(patches[k]);
}

}  // namespace

std::int64_t find_patches(const ContactMap& map, const rc_patches& out) {
  if (out.neighbours != 4 && out.neighbours != 8)
    fail(RC_ERR_ARGUMENT, "rc_patches.neighbours = ", out.neighbours, " is neither 4 nor 8");
  if (out.room < 0) fail(RC_ERR_ARGUMENT, "rc_patches.room = ", out.room, " must be >= 0");

  const Runs runs(map);
  Sets sets = joined(runs, out.neighbours == 8, map);
  // Patches are numbered in the order of their first runs.
  constexpr std::int64_t none = -1;
  std::vector<std::int64_t> number(runs.count(), none);
  std::vector<Patch> patches;
  for (Index run = 0; run < runs.count(); ++run) {
    std::int64_t& known = number[sets.root(run)];
    if (known != none) continue;
    known = static_cast<std::int64_t>(patches.size());
    patches.emplace_back();
  }

  const std::int64_t nx = map.system().nx;
  std::int64_t* const label = values_of<std::int64_t>(out.label);
  if (label) std::fill_n(label, map.points(), none);
  for (Index row = 0; row < runs.rows(); ++row)
    for (Index run = runs.begin(row); run < runs.end(row); ++run) {
      const std::int64_t found = number[sets.root(run)], iy = static_cast<std::int64_t>(row);
      Patch& patch = patches[static_cast<Index>(found)];
      for (std::int64_t ix = runs[run].begin; ix < runs[run].end; ++ix) {
        const std::int64_t i = iy * nx + ix;
        ++patch.cells;
        patch.edges += map.edges(ix, iy);
        patch.sum += map.pressure(i);
        if (map.pressure(i) > patch.max) {
          patch.max = map.pressure(i);
          patch.peak = i;
        }
        if (label) label[i] = found;
      }
    }

  const double cell = map.cell_area();
  const auto mean = [](const Patch& each) { return each.sum / static_cast<double>(each.cells); };
  give(out.cells, out.room, patches, [](const Patch& each) { return each.cells; });
  give(out.area, out.room, patches, [&](const Patch& each) { return static_cast<double>(each.cells) * cell; });
  give(out.perimeter, out.room, patches, [&](const Patch& each) { return each.edges.length(map.system()); });
  give(out.load, out.room, patches, [&](const Patch& each) { return each.sum * cell; });
  give(out.mean_pressure, out.room, patches, mean);
  give(out.max_pressure, out.room, patches, [](const Patch& each) { return each.max; });
  give(out.peak, out.room, patches, [](const Patch& each) { return each.peak; });
  return static_cast<std::int64_t>(patches.size());
}

}  // namespace rc
