#include "rough_surface.h"

#include <roughcontact/surface.h>

#include <algorithm>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace failures {

namespace {

void require(rc_status status) {
  if (status != RC_OK) throw std::runtime_error(rc_surface_last_error());
}

constexpr double wave_number(double waves_a_side) { return 2 * std::numbers::pi * waves_a_side; }

}  // namespace

Field midpoint_surface(std::int64_t levels, double hurst, std::uint64_t seed) {
  rc_surface_rmd_spec spec = RC_SURFACE_RMD_SPEC_INIT;
  spec.seed = seed;
  spec.levels = static_cast<std::int32_t>(levels);
  spec.hurst = hurst;
  Field heights(std::size_t{1} << (2 * levels));
  require(rc_surface_rmd(&spec, spec.levels, 1, heights.data()));
  return heights;
}

Field gap_below_highest(const Field& heights) {
  const double highest = *std::max_element(heights.begin(), heights.end());
  Field gap;
  gap.reserve(heights.size());
  for (const double height : heights) gap.push_back(highest - height);
  return gap;
}

double mean_of(const Field& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Field SurfaceClass::heights(std::int64_t n, std::uint64_t seed) const {
  Field result(static_cast<std::size_t>(n * n));
  const double pitch = 1 / static_cast<double>(n);
  if (noise || period > 0) {
    rc_surface_shape_spec spec = RC_SURFACE_SHAPE_SPEC_INIT;
    spec.shape = noise ? RC_SURFACE_NOISE : RC_SURFACE_PYRAMIDS;
    spec.seed = seed;
    spec.nx = spec.ny = n;
    spec.hx = spec.hy = pitch;
    spec.period_x = spec.period_y = period * pitch;
    require(rc_surface_shape(&spec, result.data()));
    if (noise) return result;
    // Pyramids of unequal heights, as etched.
    SurfaceClass slow{"slow"};
    slow.longest = 8;
    const Field waviness = slow.heights(n, seed);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] += 0.1 * waviness[i];
    return result;
  }
  rc_surface_spectral_spec spec = RC_SURFACE_SPECTRAL_SPEC_INIT;
  spec.seed = seed;
  spec.nx = spec.ny = n;
  spec.hx = spec.hy = pitch;
  spec.hurst = hurst;
  spec.q_low = wave_number(shortest);
  spec.q_rolloff = wave_number(roll_off);
  spec.q_high = wave_number(longest);
  spec.rms_height = 1;
  spec.rms_slope = 0;
  require(rc_surface_spectral(&spec, result.data()));
  return result;
}

const std::vector<SurfaceClass>& surface_classes() {
  static const std::vector<SurfaceClass> classes = {
      {.name = "power law"},
      {.name = "roll-off at 8 waves", .roll_off = 8},
      {.name = "roll-off at 16 waves", .roll_off = 16},
      {.name = "roll-off at 48 waves", .roll_off = 48},
      {.name = "band of 40 to 80 waves", .shortest = 40, .longest = 80},
      {.name = "pyramids of 21.3 cells", .period = 64.0 / 3},
      {.name = "pyramids of 5.3 cells", .period = 16.0 / 3},
      {.name = "white noise", .noise = true},
  };
  return classes;
}

}  // namespace failures
