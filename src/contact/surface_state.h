// The gap of the current step, and the trial sets it gives.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "operator/operator.h"

namespace rc {

class SurfaceState {
 public:
  // Copies; throws Error(ARGUMENT) on values that are not finite outside the mask. An empty mask: every point.
  void set(std::span<const double> gap, std::span<const std::uint8_t> mask);
  void clear() { *this = SurfaceState(); }

  bool empty() const { return gap_.empty(); }
  bool operator==(const SurfaceState&) const;  // NaN under the mask counts as equal
  std::span<const double> gap() const { return gap_; }
  const std::uint8_t* mask() const { return mask_.empty() ? nullptr : mask_.data(); }
  bool included(std::size_t i) const { return mask_.empty() || mask_[i] != 0; }
  std::int64_t included_points() const { return included_points_; }
  bool whole() const { return mask_.empty() || included_points_ == static_cast<std::int64_t>(gap_.size()); }
  double lowest() const { return lowest_; }  // smallest gap of the included points
  double highest() const { return highest_; }
  double mean() const;  // of the included points

  // Included points with gap < limit.
  TrialSet below(double limit) const;
  TrialSet all() const { return below(std::numeric_limits<double>::infinity()); }
  std::int64_t count_below(double limit) const;

  // The height t above the lowest gap at which sum(max(t - (gap - lowest), 0)) / sqrt(points with gap - lowest < t) = target, to
  // about two percent from above.
  double bearing_height(double target) const;

 private:
  std::vector<double> gap_;
  std::vector<std::uint8_t> mask_;
  std::int64_t included_points_ = 0;
  double lowest_ = 0, highest_ = 0;
};

// Points of the bounding box of a trial set on a grid nx wide and ny high.
std::int64_t box_points(const TrialSet& trial, std::int64_t nx, std::int64_t ny);
// Every point of that box, or of the grid where it is as large.
TrialSet box_of(const TrialSet& trial, std::int64_t nx, std::int64_t ny);

}  // namespace rc
