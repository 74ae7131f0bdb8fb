// A kernel of deflections that decay with distance, which a test may spoil, and contacts with it.
#pragma once

#include <cmath>

#include "scratch.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace plugins {

inline constexpr std::int64_t side = 12;

// Changes of a kernel's values, made on purpose.
struct Spoilt {
  std::int64_t x = -1, y = -1;  // where it says `value`
  double value = 0, factor = 1, lowest = 0, share = 0;
};

inline const Spoilt& of(const rc_kernel_spec* spec) { return *static_cast<const Spoilt*>(spec->kernel->user); }

inline rc_status decay_window(const rc_host*, const rc_kernel_spec* spec, std::int64_t first_x, std::int64_t first_y,
                              std::int64_t mx, std::int64_t my, double* out) {
  for (std::int64_t iy = first_y; iy < first_y + my; ++iy)
    for (std::int64_t ix = first_x; ix < first_x + mx; ++ix)
      *out++ = ix == of(spec).x && iy == of(spec).y
                   ? of(spec).value
                   : of(spec).factor * std::exp(-std::hypot(spec->system->hx * static_cast<double>(ix),
                                                            spec->system->hy * static_cast<double>(iy)));
  return RC_OK;
}

inline rc_status decay_symbol(const rc_host*, const rc_kernel_spec* spec, double* out) {
  for (std::int64_t ky = 0; ky <= spec->system->ny / 2; ++ky)
    for (std::int64_t kx = 0; kx <= spec->system->nx / 2; ++kx)
      *out++ = kx == of(spec).x && ky == of(spec).y ? of(spec).value : 1 / (1.0 + static_cast<double>(kx * kx + ky * ky));
  return RC_OK;
}

inline rc_status decay_bounds(const rc_host*, const rc_kernel_spec* spec, double* lowest, double* galerkin_share) {
  *lowest = of(spec).lowest;
  *galerkin_share = of(spec).share;
  return RC_OK;
}

inline rc_kernel decay(Spoilt& spoilt) {
  rc_kernel kernel = component<rc_kernel>("decay");
  kernel.caps = RC_KERNEL_FREE | RC_KERNEL_PERIODIC | RC_KERNEL_POSITIVE;
  kernel.window = decay_window;
  kernel.symbol = decay_symbol;
  kernel.bounds = decay_bounds;
  kernel.user = &spoilt;
  return kernel;
}

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
