// Plain cascade multi-resolution loses the contacts of asperities that the coarse grids do not show. Only the part of the surface
// within reach of the other body counts: a plateau between deep grooves may be rough on scales that carry a small part of the
// variance of all heights.
#include "cmr_advice.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "grid/downsample.h"
#include "stop.h"
#include "structs.h"

namespace rc::surface {

namespace {

constexpr double limit = 0.5;
constexpr double points_per_wave = 4;
constexpr std::size_t fewest_points = 16;

struct Grid {
  std::int64_t nx, ny;
  std::vector<double> z;
};

Grid halved(const Grid& fine, Filter filter) {
  CoarseGrid coarse = downsample(fine.nx, fine.ny, fine.z, {}, filter);
  return {coarse.nx, coarse.ny, std::move(coarse.gap)};
}

// The position of a fine point between two coarse points: at this fraction of the way from `left` to `right`.
struct Place {
  std::int64_t left, right;
  double fraction;
};

Place place(std::int64_t k, std::int64_t coarse) {
  const double t = std::clamp(0.5 * static_cast<double>(k) - 0.25, 0.0, static_cast<double>(coarse - 1));
  const auto left = static_cast<std::int64_t>(t);
  return {left, std::min(left + 1, coarse - 1), t - static_cast<double>(left)};
}

// Bilinear interpolation between block centres.
std::vector<double> refined(const Grid& coarse, std::int64_t nx, std::int64_t ny) {
  const auto z = [&](std::int64_t x, std::int64_t y) { return coarse.z[static_cast<std::size_t>(y * coarse.nx + x)]; };
  std::vector<Place> columns;
  for (std::int64_t x = 0; x < nx; ++x) columns.push_back(place(x, coarse.nx));
  std::vector<double> fine;
  fine.reserve(static_cast<std::size_t>(nx * ny));
  for (std::int64_t y = 0; y < ny; ++y) {
    stop_if_asked();
    const Place row = place(y, coarse.ny);
    for (const Place& column : columns) {
      const double above = std::lerp(z(column.left, row.left), z(column.right, row.left), column.fraction);
      const double below = std::lerp(z(column.left, row.right), z(column.right, row.right), column.fraction);
      fine.push_back(std::lerp(above, below, row.fraction));
    }
  }
  return fine;
}

// The cascade of block means, finest first.
std::vector<Grid> cascade(const Heights& heights, std::int32_t levels) {
  std::vector<Grid> grids{{heights.nx, heights.ny, heights.z}};
  for (std::int32_t k = 0; k < levels; ++k) grids.push_back(halved(grids.back(), Filter::mean));
  return grids;
}

struct Unresolved {
  double within_reach, overall;
};

Unresolved unresolved(const std::vector<Grid>& grids, std::int32_t levels, double lowest_in_reach) {
  Grid shown = grids[static_cast<std::size_t>(levels)];
  for (auto k = static_cast<std::size_t>(levels); k-- > 0;)
    shown = {grids[k].nx, grids[k].ny, refined(shown, grids[k].nx, grids[k].ny)};

  const std::vector<double>& z = grids.front().z;
  std::vector<double> rest, reach, reach_rest;
  for (std::size_t i = 0; i < z.size(); ++i) {
    rest.push_back(z[i] - shown.z[i]);
    if (z[i] < lowest_in_reach) continue;
    reach.push_back(z[i]);
    reach_rest.push_back(rest.back());
  }
  const double spread = variance(reach);
  return {spread > 0 ? variance(reach_rest) / spread : 1, variance(rest) / variance(z)};
}

// The lowest height that counts as within reach. At least 16 points are, so that their variance means something.
double reach(std::vector<double> z, double highest, double approach) {
  const auto last = z.begin() + static_cast<std::ptrdiff_t>(std::min(fewest_points, z.size()) - 1);
  std::ranges::nth_element(z, last, std::greater{});
  return std::min(highest - approach, *last);
}

double highest_of_subsample(const Heights& heights, std::int32_t levels) {
  const std::int64_t step = std::int64_t{1} << levels;
  double highest = heights.z.front();
  for (std::int64_t y = 0; y < heights.ny; y += step)
    for (std::int64_t x = 0; x < heights.nx; x += step) highest = std::max(highest, heights.at(x, y));
  return highest;
}

void explain(rc_surface_cmr& cmr, const rc_surface_power_law& law) {
  char why[160];
  const double pitch = cmr.coarsest_pitch, period = law.peaks > 0 ? 2 * pi / std::hypot(law.peak_qx[0], law.peak_qy[0]) : 0;
  if (cmr.trustworthy) {
    std::snprintf(why, sizeof why, "the coarsest grid shows where the high parts of the surface are");
  } else if (law.peaks > 0 && period < points_per_wave * pitch) {
    std::snprintf(why, sizeof why, "its periodic texture of wavelength %.3g has fewer than %g points a wave there", period,
                  points_per_wave);
  } else if (std::isnan(law.hurst) && cmr.unresolved_overall > limit) {
    std::snprintf(why, sizeof why, "its spectrum has no power law to that pitch, and most of the roughness is finer");
  } else if (2 * pi / law.q_rolloff < 2 * points_per_wave * pitch) {
    std::snprintf(why, sizeof why, "its power law begins at a roll-off of wavelength %.3g, of which that pitch shows too little",
                  2 * pi / law.q_rolloff);
  } else if (cmr.unresolved_overall < 0.5 * cmr.unresolved) {
    std::snprintf(why, sizeof why, "the parts that touch are rough on finer scales than the surface as a whole (%.2g overall)",
                  cmr.unresolved_overall);
  } else {
    std::snprintf(why, sizeof why, "its fine roughness is not small beside the coarse one");
  }
  std::snprintf(cmr.reason, sizeof cmr.reason,
                "%s with %d halving%s to a pitch of %.3g: what that grid misses has %.2g of the variance of the heights within "
                "reach, limit %g; %s",
                cmr.trustworthy ? "trustworthy" : "not trustworthy", static_cast<int>(cmr.levels), cmr.levels == 1 ? "" : "s",
                pitch, cmr.unresolved, cmr.limit, why);
}

}  // namespace

std::int32_t most_levels(const Heights& heights) {
  std::int32_t levels = 0;
  for (std::int64_t n = std::max(heights.nx, heights.ny); (n + 1) / 2 >= 4; n = (n + 1) / 2) ++levels;
  return levels;
}

rc_surface_cmr cmr_advice(const Heights& heights, const rc_surface_power_law& law, std::int32_t levels, double approach) {
  const double highest = *std::ranges::max_element(heights.z);
  rc_surface_cmr cmr{};
  cmr.struct_size = sizeof cmr;
  cmr.levels = levels;
  cmr.limit = limit;
  cmr.approach = approach > 0 ? approach : 0.5 * highest;  // the mean height is 0
  const double coarsening = std::ldexp(1.0, levels);
  cmr.coarsest_pitch = coarsening * std::max(heights.nx > 1 ? heights.hx : 0, heights.ny > 1 ? heights.hy : 0);
  cmr.peak_loss = (highest - highest_of_subsample(heights, levels)) / cmr.approach;

  const std::vector<Grid> grids = cascade(heights, levels);
  const double lowest_in_reach = reach(heights.z, highest, cmr.approach);
  for (std::int32_t k = 1; k <= levels; ++k) {
    const Unresolved here = unresolved(grids, k, lowest_in_reach);
    if (here.within_reach <= limit && cmr.safe_levels == k - 1) cmr.safe_levels = k;
    cmr.unresolved = here.within_reach;
    cmr.unresolved_overall = here.overall;
  }
  cmr.trustworthy = cmr.safe_levels == levels ? 1 : 0;
  explain(cmr, law);
  return cmr;
}

}  // namespace rc::surface
