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

namespace {

constexpr std::size_t bins = 1024;

// Counts and sums of heights by bins of equal width over [0, range).
struct Histogram {
  explicit Histogram(double over) : range(over), count(bins, 0.0), sum(bins, 0.0) {}
  void add(double height) {
    if (!(height < range)) return;
    const auto bin = std::min(static_cast<std::size_t>(height / range * static_cast<double>(bins)), bins - 1);
    count[bin] += 1;
    sum[bin] += height;
  }
  // The upper edge of the first bin at which sum(t - height) / sqrt(count) reaches the target; range if none does.
  double reach(double target) const {
    double points = 0, heights = 0;
    for (std::size_t bin = 0; bin < bins; ++bin) {
      points += count[bin];
      heights += sum[bin];
      const double edge = range * static_cast<double>(bin + 1) / static_cast<double>(bins);
      if (points > 0 && (edge * points - heights) / std::sqrt(points) >= target) return edge;
    }
    return range;
  }
  double range;
  std::vector<double> count, sum;
};

}  // namespace

double SurfaceState::bearing_height(double target) const {
  const double n = static_cast<double>(included_points_);
  const double all = (target * std::sqrt(n) + n * (mean() - lowest_)) / n;  // if every point bears
  double range = highest_ - lowest_;
  if (all >= range) return all;
  // The range is narrowed until the bins resolve the answer.
  for (int round = 0;; ++round) {
    Histogram histogram(range);
    for (std::size_t i = 0; i < gap_.size(); ++i)
      if (included(i)) histogram.add(gap_[i] - lowest_);
    const double height = histogram.reach(target);
    if (height > 0.02 * range || round == 6) return height;
    range = 2 * height;
  }
}

namespace {

struct Box {
  std::int64_t left, right, low, high;  // of the points in it
};

Box box_around(const TrialSet& trial, std::int64_t nx, std::int64_t ny) {
  if (trial.index.empty()) return {0, nx - 1, 0, ny - 1};
  Box box{nx, -1, trial.index.front() / nx, trial.index.back() / nx};
  std::int64_t row_begin = box.low * nx;  // divides only where a row begins
  for (const std::int64_t point : trial.index) {
    if (point >= row_begin + nx) row_begin = point / nx * nx;
    box.left = std::min(box.left, point - row_begin);
    box.right = std::max(box.right, point - row_begin);
  }
  return box;
}

}  // namespace

std::int64_t box_points(const TrialSet& trial, std::int64_t nx, std::int64_t ny) {
  const Box box = box_around(trial, nx, ny);
  return (box.right - box.left + 1) * (box.high - box.low + 1);
}

TrialSet box_of(const TrialSet& trial, std::int64_t nx, std::int64_t ny) {
  const Box box = box_around(trial, nx, ny);
  TrialSet all{(box.right - box.left + 1) * (box.high - box.low + 1), {}, trial.zero_mode};
  if (all.n == nx * ny) return all;
  all.index.reserve(static_cast<std::size_t>(all.n));
  for (std::int64_t y = box.low; y <= box.high; ++y)
    for (std::int64_t x = box.left; x <= box.right; ++x) all.index.push_back(y * nx + x);
  return all;
}

}  // namespace rc
