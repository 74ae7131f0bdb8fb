#include "contact/trial_box.h"

#include <algorithm>

#include "contact/surface/extent.h"

namespace rc {

namespace {

Extent extent_of(const TrialSet& trial, std::int64_t nx, std::int64_t ny) {
  if (trial.index.empty()) return {nx * ny, 0, nx - 1, 0, ny - 1};
  Extent extent;
  extent.n = trial.n;
  extent.low = trial.index.front() / nx;
  extent.high = trial.index.back() / nx;
  for (auto at = trial.index.begin(); at != trial.index.end();) {  // once for each row, from its first point to its last
    const std::int64_t row = *at / nx * nx;
    const auto next = std::lower_bound(at, trial.index.end(), row + nx);
    extent.left = std::min(extent.left, *at - row);
    extent.right = std::max(extent.right, *(next - 1) - row);
    at = next;
  }
  return extent;
}

}  // namespace

std::int64_t box_points(const TrialSet& trial, std::int64_t nx, std::int64_t ny) { return extent_of(trial, nx, ny).box(); }

TrialSet box_of(const TrialSet& trial, std::int64_t nx, std::int64_t ny) {
  const Extent box = extent_of(trial, nx, ny);
  TrialSet all{box.box(), {}, trial.zero_mode};
  if (all.n == nx * ny) return all;
  all.index.reserve(static_cast<std::size_t>(all.n));
  for (std::int64_t y = box.low; y <= box.high; ++y)
    for (std::int64_t x = box.left; x <= box.right; ++x) all.index.push_back(y * nx + x);
  return all;
}

}  // namespace rc
