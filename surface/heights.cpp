#include "heights.h"

#include <algorithm>
#include <cmath>

#include "structs.h"

namespace rc::surface {

namespace {

void check(const rc_surface_map& map) {
  check_shape(map.nx, map.ny);
  check_magnitude("map.hx", map.hx);
  check_magnitude("map.hy", map.hy);
  if (!map.heights) fail(RC_ERR_ARGUMENT, "map.heights is null");
  if (map.periodic != 0 && map.periodic != 1) fail(RC_ERR_ARGUMENT, "map.periodic = ", map.periodic, " must be 0 or 1");
  if (map.trend < RC_SURFACE_TREND_AUTO || map.trend > RC_SURFACE_TREND_PLANE)
    fail(RC_ERR_ARGUMENT, "map.trend = ", map.trend, " must be one of RC_SURFACE_TREND_*");

  std::int64_t missing = 0, first = -1;
  double largest = 0;
  for (std::int64_t i = 0; i < map.nx * map.ny; ++i) {
    if (!std::isfinite(map.heights[i])) {
      if (missing++ == 0) first = i;
    } else {
      largest = std::max(largest, std::abs(map.heights[i]));
    }
  }
  if (missing > 0)
    fail(RC_ERR_ARGUMENT, "map.heights has ", missing, " values that are not finite, first at ix=", first % map.nx,
         ", iy=", first / map.nx, "; fill them first");
  if (largest > 1e60) fail(RC_ERR_ARGUMENT, "map.heights has values up to ", largest, ", limit 1e60; choose another unit");
}

double mean(const std::vector<double>& z) {
  double sum = 0;
  for (const double value : z) sum += value;
  return sum / static_cast<double>(z.size());
}

// Removes the plane of least squares. On a full grid x and y, counted from the middle, are orthogonal to each other and to 1.
void remove_plane(Heights& heights) {
  const double x0 = 0.5 * static_cast<double>(heights.nx - 1), y0 = 0.5 * static_cast<double>(heights.ny - 1);
  double zx = 0, zy = 0, xx = 0, yy = 0;
  const auto each = [&](const auto& visit) {
    std::size_t i = 0;
    for (std::int64_t y = 0; y < heights.ny; ++y)
      for (std::int64_t x = 0; x < heights.nx; ++x, ++i)
        visit(static_cast<double>(x) - x0, static_cast<double>(y) - y0, heights.z[i]);
  };
  each([&](double x, double y, double z) {
    zx += x * z;
    zy += y * z;
    xx += x * x;
    yy += y * y;
  });
  const double sx = xx > 0 ? zx / xx : 0, sy = yy > 0 ? zy / yy : 0;
  each([&](double x, double y, double& z) { z -= sx * x + sy * y; });
}

}  // namespace

Heights read_heights(const rc_surface_map* given) {
  const rc_surface_map map = read(given, "rc_surface_map", rc_surface_map RC_SURFACE_MAP_INIT);
  check(map);
  Heights heights{map.nx, map.ny, map.hx, map.hy, map.periodic == 1, {map.heights, map.heights + map.nx * map.ny}};

  const double level = mean(heights.z);
  double largest = 0;
  for (double& value : heights.z) {
    value -= level;
    largest = std::max(largest, std::abs(value));
  }
  const bool plane = map.trend == RC_SURFACE_TREND_PLANE || (map.trend == RC_SURFACE_TREND_AUTO && !heights.periodic);
  if (plane) remove_plane(heights);

  // The remainder of a flat or tilted surface is round-off, not roughness.
  const double noise = 1e-13 * (std::abs(level) + largest);
  if (std::ranges::all_of(heights.z, [noise](double value) { return std::abs(value) <= noise; }))
    std::ranges::fill(heights.z, 0.0);
  return heights;
}

double variance(const std::vector<double>& values) {
  const double middle = mean(values);
  double squares = 0;
  for (const double value : values) squares += (value - middle) * (value - middle);
  return squares / static_cast<double>(values.size());
}

double mean_square(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return sum / static_cast<double>(values.size());
}

double standard_moment(const std::vector<double>& values, int order) {
  const double deviation = std::sqrt(mean_square(values));
  if (!(deviation > 0)) return no_value;
  double sum = 0;
  for (const double value : values) {
    const double t = value / deviation;
    sum += order == 3 ? t * t * t : t * t * t * t;
  }
  return sum / static_cast<double>(values.size());
}

}  // namespace rc::surface
