#include "contact/surface_state.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace rc {

void SurfaceState::set(std::span<const double> gap, std::span<const std::uint8_t> mask) {
  SurfaceState fresh;
  fresh.mask_.assign(mask.begin(), mask.end());
  std::size_t bad = 0, first_bad = 0;
  fresh.lowest_ = std::numeric_limits<double>::infinity();
  fresh.highest_ = -fresh.lowest_;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    if (!fresh.included(i)) continue;
    ++fresh.included_points_;
    if (!std::isfinite(gap[i])) {
      if (bad++ == 0) first_bad = i;
      continue;
    }
    fresh.lowest_ = std::min(fresh.lowest_, gap[i]);
    fresh.highest_ = std::max(fresh.highest_, gap[i]);
  }
  if (bad > 0)
    fail(RC_ERR_ARGUMENT, "gap has ", bad, " value(s) that are not finite, first at index ", first_bad, " (", gap[first_bad],
         "); exclude them with rc_step.mask");
  fresh.gap_.assign(gap.begin(), gap.end());
  *this = std::move(fresh);
}

bool SurfaceState::operator==(const SurfaceState& other) const {
  if (gap_.size() != other.gap_.size() || mask_ != other.mask_) return false;
  for (std::size_t i = 0; i < gap_.size(); ++i)
    if (included(i) && gap_[i] != other.gap_[i]) return false;
  return true;
}

double SurfaceState::mean() const {
  double sum = 0;
  for (std::size_t i = 0; i < gap_.size(); ++i)
    if (included(i)) sum += gap_[i] - lowest_;
  return lowest_ + sum / static_cast<double>(included_points_);
}

std::int64_t SurfaceState::count_below(double limit) const {
  std::int64_t count = 0;
  for (std::size_t i = 0; i < gap_.size(); ++i) count += included(i) && gap_[i] < limit;
  return count;
}

TrialSet SurfaceState::below(double limit) const {
  TrialSet trial;
  trial.n = count_below(limit);
  if (trial.n == static_cast<std::int64_t>(gap_.size())) return trial;
  trial.index.reserve(static_cast<std::size_t>(trial.n));
  for (std::size_t i = 0; i < gap_.size(); ++i)
    if (included(i) && gap_[i] < limit) trial.index.push_back(static_cast<std::int64_t>(i));
  return trial;
}

double SurfaceState::bearing_height(double volume) const {
  // Newton's method on a convex increasing function, from above.
  double height = (highest_ - lowest_) + volume / static_cast<double>(included_points_);
  for (int round = 0; round < 60; ++round) {
    double filled = 0, count = 0;
    for (std::size_t i = 0; i < gap_.size(); ++i) {
      const double depth = included(i) ? height - (gap_[i] - lowest_) : 0;
      if (depth <= 0) continue;
      filled += depth;
      count += 1;
    }
    const double excess = filled - volume;
    if (count == 0 || excess <= 1e-3 * volume) break;
    height -= excess / count;
  }
  return height;
}

std::int64_t box_points(const TrialSet& trial, std::int64_t nx, std::int64_t ny) {
  if (trial.index.empty()) return nx * ny;
  std::int64_t left = nx, right = -1;
  for (const std::int64_t point : trial.index) {
    left = std::min(left, point % nx);
    right = std::max(right, point % nx);
  }
  return (right - left + 1) * (trial.index.back() / nx - trial.index.front() / nx + 1);
}

}  // namespace rc
