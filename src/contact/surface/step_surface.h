// The undeformed gap of the current step, and which points of it count.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "contact/surface/gathered_tiles.h"
#include "contact/surface/height_moments.h"
#include "contact/surface/surface_points.h"
#include "contact/surface/tile_lows.h"
#include "core/rows.h"
#include "grid/gap_values.h"
#include "operator/operator.h"

namespace rc {

// A gap over nx * ny points, and which of them count; an empty mask: all.
// By rows: over those of this process.
struct GivenSurface {
  std::int64_t nx = 0, ny = 0;
  GapValues gap;
  std::span<const std::uint8_t> mask;
  bool borrowed = false;  // not copied: the arrays outlive the state
  double side = 0;        // [length] by rows: the longer one, if solvers work on it; there masked points stay unknowns
  int roundings = 0;      // of the gap, if it is a sum of a gap and what earlier steps have left
};

// The gaps of the included points, of all processes.
struct GapRange {
  std::int64_t included = 0;  // how many points there are
  bool whole = true;          // no point is masked
  double lowest = 0, highest = 0;
  double rounding = 0;  // [length] error of each gap, if it is a sum that was rounded

  double width() const { return highest - lowest; }
  // A limit such that every included point below this height has gap < limit.
  double limit_of(double height) const;
};

class StepSurface {
 public:
  StepSurface() = default;
  // Throws Error(ARGUMENT) on values that are not finite outside the mask. The team must outlive it. By rows, points are
  // those of this process, the range is that of the whole surface, and all processes call the same functions.
  StepSurface(const GivenSurface& given, const rc_team& team, const Rows& rows = {});
  // All of a surface that processes share: each has the tiles of it that all have asked for, and can give the gap there alone.
  // They call its functions together. shared must outlive it.
  StepSurface(const StepSurface& shared, const rc_team& team);
  StepSurface(StepSurface&&) = default;
  StepSurface& operator=(StepSurface&&) = default;

  bool empty() const { return points_.nx() == 0; }
  const SurfacePoints& points() const { return points_; }
  const TileLows& tiles() const { return tiles_; }
  // Null, or the tiles of it that this process has.
  GatheredTiles* gathered() const { return gathered_.get(); }
  // The points that this process itself looks at: all, or those of its rows of a surface whose tiles it gathers.
  const StepSurface& own() const { return gathered_ ? gathered_->shared() : *this; }
  // Before the gap is read at a list of points, or in a list of tiles: gathers those tiles if it must.
  void hold_tiles_of(std::span<const std::int64_t> points) const {
    if (gathered_) gathered_->hold_tiles_of(points);
  }
  void hold(std::span<const std::int64_t> tiles) const {
    if (gathered_) gathered_->hold(tiles);
  }

  const GapValues& gap() const { return gap_; }
  std::span<const std::uint8_t> mask() const { return mask_; }  // its data are null if it is empty
  bool included(std::size_t i) const { return gathered_ ? !std::isnan(gap_at(i)) : mask_.empty() || mask_[i] != 0; }
  double gap_at(std::size_t i) const { return gathered_ ? gathered_->gap(static_cast<std::int64_t>(i)) : gap_[i]; }
  // Heights and compressions count from the lowest gap, so that no answer depends on the datum of the gap.
  double height(std::size_t i) const { return gap_at(i) - range_.lowest; }
  double lowest() const { return range_.lowest; }
  const GapRange& range() const { return range_; }
  const HeightMoments& moments() const;  // computed when first asked for

  // The points with gap < limit in one row of this process's tiles, row by row: act(point, x, y).
  template <class Act> void each_below(double limit, std::int64_t tile_row, const Act& act) const;
  // The points with gap < limit of one tile, which this process has: act(point).
  template <class Act> void each_below_in(std::int64_t tile, double limit, const Act& act) const {
    tiles_.each_point(tile, [&](std::int64_t point) {
      if (const auto i = static_cast<std::size_t>(point); included(i) && gap_at(i) < limit) act(point);
    });
  }

  // The gap that a solver reads. One that takes 4 bytes a point gets it as it is, but by rows far above all others where the mask
  // is 0. All others get 8 bytes a point, of a copy if the gap has 4, which is made when first asked for.
  rc_const_array gap_for_solver(bool takes_single) const;

 private:
  void fill_masked(double side);

  SurfacePoints points_;
  TileLows tiles_;
  std::unique_ptr<GatheredTiles> gathered_;
  std::unique_ptr<double[]> own_gap_;
  std::unique_ptr<float[]> own_single_gap_;
  std::vector<std::uint8_t> own_mask_;
  GapValues gap_;  // one's own or the caller's
  std::span<const std::uint8_t> mask_;
  GapRange range_;
  mutable std::optional<HeightMoments> moments_;
  mutable std::vector<double> gap_in_double_;
  std::vector<double> filled_double_;
  std::vector<float> filled_single_;
  GapValues filled_;
};

template <class Act> void StepSurface::each_below(double limit, std::int64_t tile_row, const Act& act) const {
  constexpr std::int64_t tile = TileLows::side;
  const std::int64_t columns = tiles_.columns(), nx = tiles_.nx;
  for (std::int64_t y = tile_row * tile; y < std::min((tile_row + 1) * tile, tiles_.ny); ++y)
    for (std::int64_t column = 0; column < columns; ++column) {
      if (!(tiles_.lowest[static_cast<std::size_t>(tile_row * columns + column)] < limit)) continue;
      std::int64_t found[tile], n = 0;  // listed without a branch, which would be foreseen wrongly
      gap_.visit([&](const auto* gap) {
        for (std::int64_t x = column * tile; x < std::min((column + 1) * tile, nx); ++x) {
          found[n] = x;
          n += static_cast<double>(gap[y * nx + x]) < limit && included(static_cast<std::size_t>(y * nx + x));
        }
      });
      for (std::int64_t k = 0; k < n; ++k) act(y * nx + found[k], found[k], y);
    }
}

// Whether gap and mask are the same; NaN under the mask counts as equal.
bool same_surface(const StepSurface& a, const StepSurface& b);
// The heights of entries first .. first+n-1 of a trial set.
void heights_of(const TrialSet& trial, const StepSurface& surface, std::size_t first, std::size_t n, double* to);

}  // namespace rc
