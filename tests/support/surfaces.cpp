#include "support/surfaces.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace pairs {

Field rough_heights(std::int64_t nx, std::int64_t ny, unsigned seed) {
  constexpr int waves = 4;
  std::mt19937 generator(seed);
  const auto uniform = [&] { return static_cast<double>(generator()) / 4294967296.0; };
  Field heights(static_cast<std::size_t>(nx * ny), 0.0);
  for (int kx = -waves; kx <= waves; ++kx)
    for (int ky = 0; ky <= waves; ++ky) {
      if (kx == 0 && ky == 0) continue;
      const double amplitude = (0.5 + uniform()) / std::pow(std::hypot(kx, ky), 1.5), phase = 2 * std::numbers::pi * uniform();
      std::size_t i = 0;
      for (std::int64_t iy = 0; iy < ny; ++iy)
        for (std::int64_t ix = 0; ix < nx; ++ix)
          heights[i++] += amplitude * std::cos(2 * std::numbers::pi *
                                                   (static_cast<double>(kx * ix) / static_cast<double>(nx) +
                                                    static_cast<double>(ky * iy) / static_cast<double>(ny)) +
                                               phase);
    }
  const double top = *std::max_element(heights.begin(), heights.end());
  for (double& height : heights) height -= top;
  return heights;
}

Problem rough_problem(std::int64_t nx, std::int64_t ny, std::int32_t boundary, double hx, double hy) {
  Problem problem;
  problem.system.boundary = boundary;
  problem.system.nx = nx;
  problem.system.ny = ny;
  problem.system.hx = hx;
  problem.system.hy = hy;
  problem.gap = rough_heights(nx, ny, 7);
  for (double& value : problem.gap) value = -value;
  problem.target = 0.5 * sum(problem.gap) / static_cast<double>(problem.points());
  return problem;
}

Problem rugged_problem(std::int64_t nx, std::int64_t ny, double depth, std::int32_t boundary) {
  Problem problem = rough_problem(nx, ny, boundary);
  std::mt19937 random(5);
  for (double& gap : problem.gap) gap += 1e-6 * static_cast<double>(random() % 100000);
  problem.target =
      problem.lowest_gap() + depth * (sum(problem.gap) / static_cast<double>(problem.points()) - problem.lowest_gap());
  return problem;
}

Field paraboloid(std::int64_t nx, std::int64_t ny, double h, double cx, double cy, double radius) {
  Field gap;
  for (std::int64_t iy = 0; iy < ny; ++iy)
    for (std::int64_t ix = 0; ix < nx; ++ix) {
      const double x = (static_cast<double>(ix) - cx) * h, y = (static_cast<double>(iy) - cy) * h;
      gap.push_back((x * x + y * y) / (2 * radius));
    }
  return gap;
}

}  // namespace pairs
