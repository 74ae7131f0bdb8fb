// Roughness parameters: ISO 25178-2 for Sq, Ssk, Sku; McCool (1987) for the spectral moments from finite differences.
#include "statistics.h"

#include <algorithm>
#include <cmath>

#include "stop.h"
#include "structs.h"

namespace rc::surface {

namespace {

struct MeanSquare {
  double sum = 0;
  std::int64_t count = 0;
  void add(double value) {
    sum += value * value;
    ++count;
  }
  double value() const { return count > 0 ? sum / static_cast<double>(count) : 0; }
};

struct Differences {
  MeanSquare slope_x, slope_y, second_x, second_y, curvature;
};

Differences differences(const Heights& heights) {
  Differences result;
  const std::int64_t nx = heights.nx, ny = heights.ny;
  const auto wrapped = [](std::int64_t k, std::int64_t n) { return k < 0 ? k + n : k >= n ? k - n : k; };
  const auto inside = [&](std::int64_t k, std::int64_t n) { return n > 1 && (heights.periodic || (k >= 0 && k < n)); };
  const auto z = [&](std::int64_t x, std::int64_t y) { return heights.at(wrapped(x, nx), wrapped(y, ny)); };

  for (std::int64_t y = 0; y < ny; ++y) {
    stop_if_asked();
    for (std::int64_t x = 0; x < nx; ++x) {
      const double here = heights.at(x, y);
      if (inside(x + 1, nx)) result.slope_x.add((z(x + 1, y) - here) / heights.hx);
      if (inside(y + 1, ny)) result.slope_y.add((z(x, y + 1) - here) / heights.hy);
      const bool has_x = inside(x - 1, nx) && inside(x + 1, nx), has_y = inside(y - 1, ny) && inside(y + 1, ny);
      const double zxx = has_x ? (z(x - 1, y) + z(x + 1, y) - 2 * here) / (heights.hx * heights.hx) : 0;
      const double zyy = has_y ? (z(x, y - 1) + z(x, y + 1) - 2 * here) / (heights.hy * heights.hy) : 0;
      if (has_x) result.second_x.add(zxx);
      if (has_y) result.second_y.add(zyy);
      if ((has_x || nx == 1) && (has_y || ny == 1)) result.curvature.add((zxx + zyy) / 2);
    }
  }
  return result;
}

}  // namespace

rc_surface_statistics statistics(const Heights& heights) {
  const Differences d = differences(heights);
  const double directions = std::max(heights.dimensions(), 1);
  const auto [lowest, highest] = std::ranges::minmax(heights.z);

  rc_surface_statistics s{};
  s.struct_size = sizeof s;
  s.m0 = mean_square(heights.z);
  s.m2 = (d.slope_x.value() + d.slope_y.value()) / directions;
  s.m4 = (d.second_x.value() + d.second_y.value()) / directions;
  s.nayak = s.m2 > 0 ? s.m0 * s.m4 / (s.m2 * s.m2) : no_value;
  s.rms_height = std::sqrt(s.m0);
  s.skewness = standard_moment(heights.z, 3);
  s.kurtosis = standard_moment(heights.z, 4);
  s.highest = highest;
  s.lowest = lowest;
  s.rms_slope_x = std::sqrt(d.slope_x.value());
  s.rms_slope_y = std::sqrt(d.slope_y.value());
  s.rms_slope = std::hypot(s.rms_slope_x, s.rms_slope_y);
  s.rms_curvature = std::sqrt(d.curvature.value());
  return s;
}

}  // namespace rc::surface
