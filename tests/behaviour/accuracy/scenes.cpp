#include "scenes.h"

#include <roughcontact/surface.h>

#include <algorithm>
#include <numeric>

#include "support/surfaces.h"

namespace accuracy {

namespace {

// Pressed in to a fraction of the mean gap; the highest point touches first.
Problem pressed(std::int64_t n, std::int32_t boundary, Field heights, double depth) {
  Problem problem;
  problem.system.boundary = boundary;
  problem.system.nx = problem.system.ny = n;
  const double top = *std::max_element(heights.begin(), heights.end());
  for (double& height : heights) height = top - height;
  problem.target = depth * std::accumulate(heights.begin(), heights.end(), 0.0) / static_cast<double>(heights.size());
  problem.gap = std::move(heights);
  return problem;
}

}  // namespace

Problem midpoint_problem(std::int64_t levels, double hurst, std::uint64_t seed, double depth) {
  rc_surface_rmd_spec spec = RC_SURFACE_RMD_SPEC_INIT;
  spec.seed = seed;
  spec.levels = static_cast<std::int32_t>(levels);
  spec.hurst = hurst;
  const std::int64_t n = std::int64_t{1} << levels;
  Field heights(static_cast<std::size_t>(n * n));
  check(rc_surface_rmd(&spec, spec.levels, 1, heights.data()) == RC_OK, rc_surface_last_error());
  return pressed(n, RC_BOUNDARY_FREE, std::move(heights), depth);
}

Problem waves_problem(std::int64_t n, std::int32_t boundary, unsigned seed, double depth) {
  return pressed(n, boundary, rough_heights(n, n, seed), depth);
}

Problem block_means(const Problem& problem, std::int64_t factor) {
  Problem coarse = problem;
  coarse.system.nx /= factor;
  coarse.system.ny /= factor;
  coarse.system.hx *= static_cast<double>(factor);
  coarse.system.hy *= static_cast<double>(factor);
  coarse.gap.assign(coarse.points(), 0.0);
  for (std::int64_t iy = 0; iy < problem.system.ny; ++iy)
    for (std::int64_t ix = 0; ix < problem.system.nx; ++ix)
      coarse.gap[static_cast<std::size_t>(iy / factor * coarse.system.nx + ix / factor)] +=
          problem.gap[static_cast<std::size_t>(iy * problem.system.nx + ix)] / static_cast<double>(factor * factor);
  return coarse;
}

Settings goal(double error, const char* of, const char* tol) {
  return {{RC_OPT_TOL, tol}, {RC_OPT_ACCURACY, text(error)}, {RC_OPT_ACCURACY_OF, of}};
}

}  // namespace accuracy
