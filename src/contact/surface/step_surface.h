// The undeformed gap of the current step, and the trial sets that follow from it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "contact/surface/gathered_tiles.h"
#include "core/company.h"
#include "grid/gap_values.h"
#include "operator/operator.h"

namespace rc {

// How many points there are, and their bounding box; columns left .. right, rows low .. high.
struct Extent {
  std::int64_t n = 0;
  std::int64_t left = std::numeric_limits<std::int64_t>::max(), right = -1, low = left, high = -1;

  void add(std::int64_t x, std::int64_t y) {
    ++n;
    left = std::min(left, x);
    right = std::max(right, x);
    low = std::min(low, y);
    high = std::max(high, y);
  }
  std::int64_t width() const { return n > 0 ? right - left + 1 : 0; }
  std::int64_t height() const { return n > 0 ? high - low + 1 : 0; }
  std::int64_t box() const { return width() * height(); }

  friend Extent operator+(const Extent& a, const Extent& b) {
    return {a.n + b.n, std::min(a.left, b.left), std::max(a.right, b.right), std::min(a.low, b.low), std::max(a.high, b.high)};
  }
};

// A gap over nx * ny points, and which of them count; an empty mask: all.
// By rows: over those of this process.
struct GivenSurface {
  std::int64_t nx = 0, ny = 0;
  GapValues gap;
  std::span<const std::uint8_t> mask;
  bool borrowed = false;  // not copied: the arrays outlive the state
};

class StepSurface {
 public:
  StepSurface() = default;
  // Throws Error(ARGUMENT) on values that are not finite outside the mask. The team must outlive it. By rows, points are
  // those of this process, numbers and extents those of the whole surface, and all processes call the same functions.
  StepSurface(const GivenSurface& given, const rc_team& team, const Company& company = {});
  // All of a surface that processes share: each has the tiles of it that all have asked for, and can give the gap there alone.
  // They call its functions together. shared must outlive it.
  StepSurface(const StepSurface& shared, const rc_team& team);
  StepSurface(StepSurface&&) = default;
  StepSurface& operator=(StepSurface&&) = default;
  void clear() { *this = StepSurface(); }

  bool empty() const { return !team_; }
  std::int64_t nx() const { return nx_; }
  const Company& company() const { return company_; }
  std::int64_t first_row() const { return company_.first_row(); }
  std::int64_t points() const { return tiles_ ? all_points_ : static_cast<std::int64_t>(gap_.size()); }  // of this process
  // Null, or the tiles of it that this process has.
  GatheredTiles* tiles() const { return tiles_.get(); }
  Chunks chunks() const { return company_.chunks(nx_); }
  // The sum of what add(part, entry) adds for entries 0 .. n-1, by pieces of a fixed size. entry(k): its point, ascending with k.
  template <class Part, class Entry, class Add> Part sum_over(std::size_t n, const Entry& entry, const Add& add) const {
    return company_.sum_over<Part>(n, points(), nx_, team(), entry, add);
  }
  // The same for a list of points.
  template <class Part, class Add> Part sum_over(std::span<const std::size_t> entries, const Add& add) const {
    return sum_over<Part>(
        entries.size(), [&](std::size_t k) { return entries[k]; }, add);
  }
  // Combines the entries of all processes by add(part, entry), for parts that are exact in any order: counts, extents, extremes.
  template <class Part, class Add> Part combined_over(std::span<const std::size_t> entries, const Add& add) const {
    return united(reduce<Part>(static_cast<std::int64_t>(entries.size()), team(), [&](std::int64_t begin, std::int64_t count) {
      Part part;
      for (const std::size_t entry : entries.subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(count)))
        add(part, entry);
      return part;
    }));
  }
  // The sum over all processes, if the order does not matter.
  template <class Part> Part united(const Part& mine) const { return company_.united(mine); }
  const rc_team& team() const { return *team_; }
  bool equals(const StepSurface&, const rc_team& team) const;  // NaN under the mask counts as equal
  const GapValues& gap() const { return gap_; }
  // The same in 8 bytes a point: a copy, made when first asked for, where the gap has 4.
  const double* gap_in_double() const;
  // By rows: the gap that a solver reads, which is far above all others where the mask is 0. Call fill_masked() first.
  const GapValues& gap_for_solver() const { return filled_.empty() ? gap_ : filled_; }
  void fill_masked(double side);
  std::span<const std::uint8_t> masks() const { return mask_; }
  const std::uint8_t* mask() const { return mask_.empty() ? nullptr : mask_.data(); }
  bool included(std::size_t i) const { return tiles_ ? !std::isnan(gap_at(i)) : mask_.empty() || mask_[i] != 0; }
  double gap_at(std::size_t i) const { return tiles_ ? tiles_->gap(static_cast<std::int64_t>(i)) : gap_[i]; }
  std::int64_t included_points() const { return included_points_; }
  bool whole() const { return included_points_ == all_points_; }
  double lowest() const { return lowest_; }  // smallest gap of the included points
  double highest() const { return highest_; }
  double mean() const { return lowest_ + mean_height(); }  // of the included points

  // Heights and compressions count from the lowest gap, so that no answer depends on the datum of the gap.
  double height(std::size_t i) const { return gap_at(i) - lowest_; }
  // The same for entries first .. first+n-1 of a trial set.
  void heights(const TrialSet& of, std::size_t first, std::size_t n, double* to) const;
  // Of the included points.
  struct HeightMoments {
    double mean = 0;    // [length] off by no more than 1e-13 of the range
    double square = 0;  // [length^2] sum of the squared differences to the mean
  };
  const HeightMoments& height_moments() const;
  double mean_height() const { return height_moments().mean; }
  double range() const { return highest_ - lowest_; }
  // A limit such that every included point below this height has gap < limit.
  double limit_of(double height) const;

  // Included points with gap < limit.
  TrialSet below(double limit) const;
  TrialSet all() const { return below(std::numeric_limits<double>::infinity()); }
  Extent extent_below(double limit) const;
  Extent own_extent_below(double limit) const;  // of this process

  // Tiles are squares of 16 x 16 points from the first on; those at the ends may be cut off.
  static constexpr std::int64_t tile = 16;
  std::int64_t tiles_x() const { return (nx_ + tile - 1) / tile; }
  // The lowest gap of each tile's included points; infinite where a tile has none.
  std::span<const double> tile_lowest() const { return tile_lowest_; }
  // Included points with gap < limit in these tiles, whose numbers are ascending.
  TrialSet below(double limit, std::span<const std::int64_t> tiles) const;

  // The height t above the lowest gap at which sum(max(t - (gap - lowest), 0)) / sqrt(points with gap - lowest < t) = target, to
  // about two percent from above.
  double bearing_height(double target) const;

 private:
  bool threaded() const { return gap_.size() > 64 * 64; }  // with fewer points threads would cost more than they save
  // The points with gap < limit in one row of tiles, row by row: visit(point, x, y).
  template <class Visit> void visit_below(double limit, std::int64_t tile_row, const Visit& visit) const;
  std::vector<Extent> extents_below(double limit) const;

  const rc_team* team_ = nullptr;
  Company company_;
  std::unique_ptr<GatheredTiles> tiles_;
  std::int64_t nx_ = 0, ny_ = 0, all_points_ = 0;
  std::unique_ptr<double[]> own_gap_;
  std::unique_ptr<float[]> own_single_gap_;
  std::vector<std::uint8_t> own_mask_;
  GapValues gap_;  // one's own or the caller's
  std::span<const std::uint8_t> mask_;
  std::vector<double> tile_lowest_;
  std::int64_t included_points_ = 0;
  double lowest_ = 0, highest_ = 0;
  mutable std::optional<HeightMoments> height_moments_;  // computed when first asked for
  mutable std::vector<double> gap_in_double_;            // likewise
  std::vector<double> filled_double_;
  std::vector<float> filled_single_;
  GapValues filled_;
};

template <class Visit> void StepSurface::visit_below(double limit, std::int64_t tile_row, const Visit& visit) const {
  const std::int64_t columns = tiles_x();
  for (std::int64_t y = tile_row * tile; y < std::min((tile_row + 1) * tile, ny_); ++y)
    for (std::int64_t column = 0; column < columns; ++column) {
      if (!(tile_lowest_[static_cast<std::size_t>(tile_row * columns + column)] < limit)) continue;
      std::int64_t found[tile], n = 0;  // listed without a branch, which would be foreseen wrongly
      gap_.visit([&](const auto* gap) {
        for (std::int64_t x = column * tile; x < std::min((column + 1) * tile, nx_); ++x) {
          found[n] = x;
          n += static_cast<double>(gap[y * nx_ + x]) < limit && included(static_cast<std::size_t>(y * nx_ + x));
        }
      });
      for (std::int64_t k = 0; k < n; ++k) visit(y * nx_ + found[k], found[k], y);
    }
}

// Points of the bounding box of a trial set on a grid nx wide and ny high.
std::int64_t box_points(const TrialSet& trial, std::int64_t nx, std::int64_t ny);
// Every point of that box; without an index if the box is the whole grid.
TrialSet box_of(const TrialSet& trial, std::int64_t nx, std::int64_t ny);

}  // namespace rc
