// Contacts with a kernel of deflections that decay with distance, which a test may spoil.
#pragma once

#include <cmath>

#include "scratch.h"
#include "support/decay.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace plugins {

inline constexpr std::int64_t side = 12;

using Spoilt = support::Decay;
inline rc_kernel decay(Spoilt& spoilt) { return support::decay_kernel("decay", spoilt); }

// A paraboloid to be pressed with a kernel of one's own.
inline pairs::Problem paraboloid_of(std::int32_t boundary = RC_BOUNDARY_FREE, double cell = 1, std::int64_t points = side) {
  pairs::Problem problem;
  problem.system.nx = problem.system.ny = points;
  problem.system.hx = problem.system.hy = cell;
  problem.system.boundary = boundary;
  problem.gap = pairs::paraboloid(points, points, cell, 5.5, 5.25, 25 * cell);
  problem.target = 0.4 * cell;
  return problem;
}
inline Pressed pressed(const Registry& registry, pairs::Settings settings = {}, std::int32_t boundary = RC_BOUNDARY_FREE) {
  settings.insert(settings.begin(), {{RC_OPT_TOL, "1e-8"}, {RC_OPT_KERNEL, "decay"}});
  return Pressed(registry, paraboloid_of(boundary), settings);
}

inline void assert_near(double value, double wanted, double tolerance) {
  pairs::check_near(value, wanted, tolerance * std::abs(wanted), "value");
}

// The same coefficients as a matrix of the caller's.
inline double load_of_matrix(double rate) {
  pairs::Problem problem = paraboloid_of();
  pairs::Field h;
  for (std::int64_t i = 0; i < side * side; ++i)
    for (std::int64_t j = 0; j < side * side; ++j)
      h.push_back(
          std::exp(-rate * std::hypot(static_cast<double>(i % side - j % side), static_cast<double>(i / side - j / side))));
  problem.system.op = RC_OPERATOR_DENSE;
  problem.system.dense = h.data();
  problem.system.dense_ld = side * side;
  return pairs::solved(problem, pairs::automatic).result.load;
}

}  // namespace plugins
