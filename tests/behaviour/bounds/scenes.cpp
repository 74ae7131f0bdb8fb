#include "scenes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "support/surfaces.h"

namespace pairs {

namespace {

double normal(std::mt19937& generator) { return std::normal_distribution<double>()(generator); }

std::int64_t below(std::mt19937& generator, std::int64_t n) {
  return static_cast<std::int64_t>(generator() % static_cast<std::uint64_t>(n));
}

Field random_gap(const Problem& problem, std::mt19937& generator) {
  const rc_system& s = problem.system;
  Field gap = below(generator, 3) == 0 ? paraboloid(s.nx, s.ny, 1, uniform(generator) * static_cast<double>(s.nx),
                                                    uniform(generator) * static_cast<double>(s.ny), 1 + 20 * uniform(generator))
                                       : rough_heights(s.nx, s.ny, static_cast<unsigned>(generator()));
  if (below(generator, 2) == 0)
    for (double& value : gap) value = -value;
  if (below(generator, 3) == 0)
    for (double& value : gap) value += normal(generator);
  if (below(generator, 10) == 0) std::ranges::fill(gap, normal(generator));
  const double size = std::pow(10, 4 * uniform(generator) - 2);
  for (double& value : gap) value *= size;
  return gap;
}

// An approach between the lowest gap and beyond the highest one; with periodic boundaries and no mask below the mean.
double random_approach(const Problem& problem, std::mt19937& generator) {
  double lowest = HUGE_VAL, highest = -HUGE_VAL, total = 0;
  for (std::size_t i = 0; i < problem.points(); ++i) {
    total += problem.gap[i];
    if (!problem.included(i)) continue;
    lowest = std::min(lowest, problem.gap[i]);
    highest = std::max(highest, problem.gap[i]);
  }
  const double mean = total / static_cast<double>(problem.points());
  double share = uniform(generator) * uniform(generator);
  if (below(generator, 8) == 0) share *= -1;
  if (problem.periodic() && problem.mask.empty())
    return highest > lowest ? lowest + 0.95 * share * (mean - lowest) : lowest - std::abs(lowest);
  return lowest + 2 * share * (highest - lowest + 1e-3);
}

// A'A/m + shift: both signs, or none negative.
Field random_matrix(std::int64_t n, std::mt19937& generator) {
  const bool positive = below(generator, 2) == 0;
  const std::int64_t m = n + 2;
  Field a(static_cast<std::size_t>(n * m)), matrix(static_cast<std::size_t>(n * n));
  for (double& value : a) value = positive ? std::abs(normal(generator)) : normal(generator);
  const double shift = std::pow(10, -3 * uniform(generator)), scale = std::pow(10, 6 * uniform(generator) - 3);
  for (std::int64_t i = 0; i < n; ++i)
    for (std::int64_t j = 0; j < n; ++j)
      matrix[static_cast<std::size_t>(i * n + j)] =
          scale *
          (std::inner_product(a.begin() + i * m, a.begin() + (i + 1) * m, a.begin() + j * m, 0.0) / static_cast<double>(m) +
           (i == j ? shift : 0));
  return matrix;
}

}  // namespace

double uniform(std::mt19937& generator) { return static_cast<double>(generator()) / 4294967296.0; }

Scene random_scene(std::mt19937& generator, std::int64_t most) {
  Scene scene;
  Problem& problem = scene.problem;
  rc_system& s = problem.system;
  s.nx = 1 + below(generator, most);
  s.ny = 1 + below(generator, most);
  s.modulus = std::pow(10, 4 * uniform(generator) - 2);
  s.hx = s.hy = std::pow(10, 2 * uniform(generator) - 1);
  constexpr const char* kernels[] = {"love", "galerkin", "disc", "punch", "eq9", "spectral", "spectral", "matrix"};
  const std::string kernel = kernels[below(generator, 8)];
  if (kernel == "matrix") {
    s.nx = std::min<std::int64_t>(s.nx, 12);
    s.ny = std::min<std::int64_t>(s.ny, 8);
    s.op = RC_OPERATOR_DENSE;
    s.dense_ld = s.nx * s.ny;
    scene.matrix = random_matrix(s.dense_ld, generator);
    s.dense = scene.matrix.data();
  } else {
    problem.kernel = kernel;
    if (kernel == "spectral") s.boundary = RC_BOUNDARY_PERIODIC;
    if (kernel == "love" && below(generator, 2) == 0)
      s.boundary = below(generator, 2) == 0 ? RC_BOUNDARY_PERIODIC_X : RC_BOUNDARY_PERIODIC_Y;
    if (kernel == "love" || kernel == "galerkin" || kernel == "spectral")
      if (below(generator, 2) == 0) s.hy *= std::pow(10, 4 * uniform(generator) - 2);
  }
  problem.gap = random_gap(problem, generator);
  if (below(generator, 4) == 0) {
    const double excluded = uniform(generator);
    for (std::size_t i = 0; i < problem.points(); ++i) problem.mask.push_back(uniform(generator) < excluded ? 0 : 1);
    problem.mask[static_cast<std::size_t>(below(generator, s.nx * s.ny))] = 1;
    // A mask that excludes nothing leaves the approach bounded by the mean plane.
    if (std::ranges::find(problem.mask, 0) == problem.mask.end()) problem.mask.clear();
  }
  problem.target = random_approach(problem, generator);
  scene.name = kernel + " " + std::to_string(s.nx) + "x" + std::to_string(s.ny) + " hy/hx " + text(s.hy / s.hx) +
               (problem.semi_periodic() ? " semi-periodic" : "") + (problem.mask.empty() ? "" : " masked");
  return scene;
}

Field perturbed(const Problem& problem, const Field& p, double size, std::mt19937& generator) {
  Field result = p;
  double scale = size * largest(p);
  if (scale == 0) scale = size;
  const std::int64_t way = below(generator, 5);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!problem.included(i)) continue;
    double& value = result[i];
    switch (way) {
      case 0:  // everywhere
        value += scale * normal(generator);
        break;
      case 1:  // where there is contact
        if (value > 0) value += scale * normal(generator);
        break;
      case 2:  // all alike
        value *= 1 + size;
        break;
      case 3:  // in single points
        if (below(generator, 20) == 0) value += scale * normal(generator);
        break;
      default:  // a smooth field
        value += scale * std::cos(0.5 * static_cast<double>(i % static_cast<std::size_t>(problem.system.nx)));
    }
  }
  if (below(generator, 4) != 0)
    for (double& value : result) value = std::max(value, 0.0);
  return result;
}

}  // namespace pairs
