#include "kinds.h"

#include <roughcontact/surface.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>

namespace accuracy {

namespace {

constexpr std::int64_t n = 128;
constexpr double pi = std::numbers::pi;

// Repeats on every system, unlike the distributions of the standard library.
class Draw {
 public:
  Draw(unsigned seed, unsigned kind) : random_(1000 * kind + seed) {}
  double operator()(double low, double high) { return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 random_;
};

// heights(x, y) on the unit square; pressed by `depth` beyond the highest point.
template <class Heights> Problem shape(double depth, const Heights& heights, std::int32_t boundary = RC_BOUNDARY_FREE) {
  Problem problem;
  problem.system.boundary = boundary;
  problem.system.nx = problem.system.ny = n;
  problem.system.hx = problem.system.hy = 1.0 / static_cast<double>(n);
  double top = -std::numeric_limits<double>::infinity();
  for (std::int64_t iy = 0; iy < n; ++iy)
    for (std::int64_t ix = 0; ix < n; ++ix) {
      const double x = (static_cast<double>(ix) + 0.5) / n, y = (static_cast<double>(iy) + 0.5) / n;
      problem.gap.push_back(-heights(x, y));
      top = std::max(top, -problem.gap.back());
    }
  for (double& each : problem.gap) each += top;
  problem.target = depth;
  if (boundary == RC_BOUNDARY_PERIODIC)  // no load belongs to the mean plane
    problem.target =
        std::min(depth, 0.9 * std::accumulate(problem.gap.begin(), problem.gap.end(), 0.0) / static_cast<double>(n * n));
  return problem;
}

double square(double x) { return x * x; }
// A paraboloid with its top at height 0.
double bump(double x, double y, double at_x, double at_y, double radius) {
  return -(square(x - at_x) + square(y - at_y)) / (2 * radius);
}

// Depths at which a floor below the top by `floor` is just reached, or not yet, or well.
double around(Draw& draw, double floor) { return floor * std::pow(10, draw(-0.3, 0.3)); }

Problem sphere(unsigned seed) {
  Draw draw(seed, 1);
  const double x0 = draw(0.3, 0.7), y0 = draw(0.3, 0.7), radius = draw(0.5, 2);
  return shape(draw(0.002, 0.03), [&](double x, double y) { return bump(x, y, x0, y0, radius); });
}
Problem sphere_above_a_floor(unsigned seed) {
  Draw draw(seed, 2);
  const double x0 = draw(0.3, 0.7), y0 = draw(0.3, 0.7), floor = draw(0.003, 0.02), radius = draw(0.3, 2);
  return shape(around(draw, 2 * floor), [&](double x, double y) { return std::max(bump(x, y, x0, y0, radius), -floor); });
}
Problem spheres_above_a_floor(unsigned seed) {
  Draw draw(seed, 3);
  const double floor = draw(0.003, 0.01), radius = draw(0.2, 0.6), lower = draw(0, 0.5) * floor;
  const double a = draw(0.2, 0.3), b = draw(0.6, 0.8), c = draw(0.2, 0.8);
  return shape(around(draw, 2 * floor), [&](double x, double y) {
    return std::max({bump(x, y, a, c, radius), bump(x, y, b, a, radius) - lower, bump(x, y, b, b, radius), -floor});
  });
}
Problem cone_above_a_floor(unsigned seed) {
  Draw draw(seed, 4);
  const double x0 = draw(0.3, 0.7), y0 = draw(0.3, 0.7), floor = draw(0.005, 0.02), slope = draw(0.03, 0.1);
  return shape(around(draw, 2 * floor),
               [&](double x, double y) { return std::max(-slope * std::hypot(x - x0, y - y0), -floor); });
}

// Caps of spheres on a plane, of heights drawn up to `scatter` of the highest.
Problem grains_of(unsigned seed, unsigned kind, int count, double scatter, std::int32_t boundary = RC_BOUNDARY_FREE) {
  Draw draw(seed, kind);
  struct Grain {
    double x, y, radius, top;
  };
  std::vector<Grain> grains;
  const double floor = draw(0.002, 0.008);
  for (int k = 0; k < count; ++k)
    grains.push_back({draw(0.05, 0.95), draw(0.05, 0.95), draw(0.03, 0.15), -draw(0, scatter) * floor});
  return shape(
      around(draw, 1.6 * floor),
      [&](double x, double y) {
        double height = -floor;
        for (const Grain& each : grains) height = std::max(height, each.top + bump(x, y, each.x, each.y, each.radius));
        return height;
      },
      boundary);
}
Problem few_grains(unsigned seed) { return grains_of(seed, 5, 4, 0.5); }
Problem grains(unsigned seed) { return grains_of(seed, 6, 15, 0.5); }
Problem even_grains(unsigned seed) { return grains_of(seed, 7, 15, 0); }
Problem many_grains(unsigned seed) { return grains_of(seed, 8, 60, 0.8); }
Problem periodic_grains(unsigned seed) { return grains_of(seed, 9, 12, 0.3, RC_BOUNDARY_PERIODIC); }

Problem step(unsigned seed) {
  Draw draw(seed, 10);
  const double edge = draw(0.2, 0.8), drop = draw(0.003, 0.02), tilt = draw(-0.5, 0.5);
  return shape(around(draw, 2 * drop),
               [&](double x, double y) { return (x + tilt * (y - 0.5) < edge ? 0 : -drop) - 0.02 * square(y - 0.5); });
}
Problem staircase(unsigned seed) {
  Draw draw(seed, 11);
  const double drop = draw(0.002, 0.01), width = draw(0.1, 0.25), start = draw(0, 0.2);
  return shape(around(draw, 2.5 * drop),
               [&](double x, double y) { return -drop * std::floor(std::max(0.0, x - start) / width) - 0.01 * square(y - 0.5); });
}
Problem bowl_in_a_step(unsigned seed) {
  Draw draw(seed, 12);
  const double radius = draw(0.15, 0.4), drop = draw(0.002, 0.02);
  return shape(around(draw, 2 * drop), [&](double x, double y) { return std::hypot(x - 0.5, y - 0.5) < radius ? -drop : 0.0; });
}
Problem punch_above_a_floor(unsigned seed) {
  Draw draw(seed, 13);
  const double radius = draw(0.08, 0.3), drop = draw(0.002, 0.02), tilt = draw(0, 0.003);
  return shape(around(draw, 2 * drop),
               [&](double x, double y) { return (std::hypot(x - 0.5, y - 0.5) < radius ? 0 : -drop) - tilt * x; });
}
Problem checkers(unsigned seed) {
  Draw draw(seed, 14);
  const double cells = std::floor(draw(3, 9)), drop = draw(0.001, 0.005);
  return shape(around(draw, 2 * drop), [&](double x, double y) {
    return static_cast<std::int64_t>(std::floor(x * cells) + std::floor(y * cells)) % 2 == 0 ? 0.0 : -drop;
  });
}
Problem pyramids(unsigned seed) {
  Draw draw(seed, 15);
  const double period = 1 / std::floor(draw(2, 6)), height = draw(0.01, 0.05), phase = draw(0, 1);
  return shape(height * draw(0.1, 0.6), [&](double x, double y) {
    const auto wave = [&](double at) { return std::abs(2 * (at / period - std::floor(at / period)) - 1); };
    return height * std::min(wave(x + phase), wave(y));
  });
}
Problem pyramids_above_a_floor(unsigned seed) {
  Draw draw(seed, 16);
  const double period = 1 / std::floor(draw(2, 5)), height = draw(0.01, 0.04), floor = draw(0.2, 0.6) * height;
  return shape(around(draw, 1.3 * floor), [&](double x, double y) {
    const auto wave = [&](double at) { return std::abs(2 * (at / period - std::floor(at / period)) - 1); };
    return std::max(height * std::min(wave(x), wave(y)), height - floor);
  });
}
Problem cylinder(unsigned seed) {
  Draw draw(seed, 17);
  const double angle = draw(0, pi), radius = draw(0.5, 3);
  return shape(draw(0.002, 0.02), [&](double x, double y) {
    return -square(std::cos(angle) * (x - 0.5) + std::sin(angle) * (y - 0.5)) / (2 * radius);
  });
}
Problem cylinder_above_a_floor(unsigned seed) {
  Draw draw(seed, 18);
  const double angle = draw(0, pi), radius = draw(0.5, 3), floor = draw(0.002, 0.01);
  return shape(around(draw, 2 * floor), [&](double x, double y) {
    return std::max(-square(std::cos(angle) * (x - 0.5) + std::sin(angle) * (y - 0.5)) / (2 * radius), -floor);
  });
}
Problem ridges(unsigned seed) {
  Draw draw(seed, 19);
  const double period = draw(0.1, 0.4), height = draw(0.005, 0.03), lean = draw(0, 1);
  return shape(height * draw(0.2, 1.2), [&](double x, double y) { return height * std::cos(2 * pi * (x + lean * y) / period); });
}
Problem grooves(unsigned seed) {
  Draw draw(seed, 20);
  const double period = draw(0.12, 0.4), depth = draw(0.002, 0.01), share = draw(0.3, 0.8);
  return shape(around(draw, 2 * depth), [&](double x, double y) {
    return (x / period - std::floor(x / period) < share ? 0 : -depth) - 0.005 * (square(x - 0.5) + square(y - 0.5));
  });
}
Problem wedge_above_a_floor(unsigned seed) {
  Draw draw(seed, 21);
  const double at = draw(0.3, 0.7), slope = draw(0.02, 0.1), floor = draw(0.003, 0.02);
  return shape(around(draw, 2 * floor),
               [&](double x, double y) { return std::max(-slope * std::abs(x - at + 0.1 * y), -floor); });
}
Problem ring_around_a_floor(unsigned seed) {
  Draw draw(seed, 22);
  const double radius = draw(0.15, 0.35), width = draw(0.02, 0.1), floor = draw(0.003, 0.02);
  return shape(around(draw, 2 * floor), [&](double x, double y) {
    return std::max(-floor * square((std::hypot(x - 0.5, y - 0.5) - radius) / width), -floor);
  });
}

Problem midpoint(unsigned seed, double hurst, unsigned kind) {
  Draw draw(seed, kind);
  return midpoint_problem(7, hurst, seed, draw(0.1, 1));
}
Problem midpoint_3(unsigned seed) { return midpoint(seed, 0.3, 23); }
Problem midpoint_7(unsigned seed) { return midpoint(seed, 0.7, 24); }
Problem midpoint_9(unsigned seed) { return midpoint(seed, 0.9, 25); }
Problem free_waves(unsigned seed) {
  Draw draw(seed, 26);
  return waves_problem(n, RC_BOUNDARY_FREE, seed, draw(0.1, 1));
}
Problem periodic_waves(unsigned seed) {
  Draw draw(seed, 27);
  return waves_problem(n, RC_BOUNDARY_PERIODIC, seed, draw(0.1, 0.95));
}

// Self-affine, periodic; `cut` of the heights' range below the top is a plateau.
Problem spectral(unsigned seed, unsigned kind, double hurst, double q_high, double plateau, std::int32_t boundary) {
  Draw draw(seed, kind);
  rc_surface_spectral_spec spec = RC_SURFACE_SPECTRAL_SPEC_INIT;
  spec.seed = seed;
  spec.nx = spec.ny = n;
  spec.hx = spec.hy = 1;
  spec.hurst = hurst;
  spec.q_high = q_high * pi;
  Field heights(static_cast<std::size_t>(n * n));
  check(rc_surface_spectral(&spec, heights.data()) == RC_OK, rc_surface_last_error());
  if (plateau > 0)
    for (double& each : heights) each = std::min(each, plateau);
  const double depth = draw(0.1, 0.9), top = *std::max_element(heights.begin(), heights.end());
  return shape(
      depth * top * 0.01,
      [&](double x, double y) {
        return 0.01 * heights[static_cast<std::size_t>(std::floor(y * n)) * n + static_cast<std::size_t>(std::floor(x * n))];
      },
      boundary);
}
Problem smooth_spectral(unsigned seed) { return spectral(seed, 28, 0.8, 0.1, 0, RC_BOUNDARY_PERIODIC); }
Problem self_affine(unsigned seed) { return spectral(seed, 29, 0.8, 1, 0, RC_BOUNDARY_PERIODIC); }
Problem rough_self_affine(unsigned seed) { return spectral(seed, 30, 0.3, 1, 0, RC_BOUNDARY_FREE); }
Problem honed(unsigned seed) { return spectral(seed, 31, 0.8, 0.3, 0.5, RC_BOUNDARY_FREE); }

// A rough plane with grains on it.
Problem grains_on_a_rough_floor(unsigned seed) {
  Problem problem = grains_of(seed, 32, 8, 0.3);
  Draw draw(seed, 33);
  const double height = draw(0.02, 0.2) * problem.target;
  for (std::size_t i = 0; i < problem.points(); ++i)
    problem.gap[i] += height * (1 + std::sin(0.21 * static_cast<double>(i % n)) * std::cos(0.17 * static_cast<double>(i / n)));
  return problem;
}
Problem waves_with_a_step(unsigned seed) {
  Problem problem = waves_problem(n, RC_BOUNDARY_FREE, seed + 100, 0.5);
  Draw draw(seed, 34);
  const double edge = draw(0.3, 0.7) * n, drop = draw(0.2, 1) * problem.target;
  for (std::size_t i = 0; i < problem.points(); ++i)
    if (static_cast<double>(i % n) > edge) problem.gap[i] += drop;
  const double lowest = *std::min_element(problem.gap.begin(), problem.gap.end());
  problem.target = lowest + around(draw, drop);
  return problem;
}

}  // namespace

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = {{"sphere", sphere},
                                        {"sphere above a floor", sphere_above_a_floor},
                                        {"spheres above a floor", spheres_above_a_floor},
                                        {"cone above a floor", cone_above_a_floor},
                                        {"few grains", few_grains},
                                        {"grains", grains},
                                        {"even grains", even_grains},
                                        {"many grains", many_grains},
                                        {"periodic grains", periodic_grains},
                                        {"grains on a rough floor", grains_on_a_rough_floor},
                                        {"step", step},
                                        {"staircase", staircase},
                                        {"bowl in a step", bowl_in_a_step},
                                        {"punch above a floor", punch_above_a_floor},
                                        {"checkers", checkers},
                                        {"pyramids", pyramids},
                                        {"pyramids above a floor", pyramids_above_a_floor},
                                        {"cylinder", cylinder},
                                        {"cylinder above a floor", cylinder_above_a_floor},
                                        {"ridges", ridges},
                                        {"grooves", grooves},
                                        {"wedge above a floor", wedge_above_a_floor},
                                        {"ring around a floor", ring_around_a_floor},
                                        {"midpoint displacement, H 0.3", midpoint_3},
                                        {"midpoint displacement, H 0.7", midpoint_7},
                                        {"midpoint displacement, H 0.9", midpoint_9},
                                        {"free waves", free_waves},
                                        {"periodic waves", periodic_waves},
                                        {"waves with a step", waves_with_a_step},
                                        {"smooth spectral", smooth_spectral},
                                        {"self-affine, H 0.8", self_affine},
                                        {"self-affine, H 0.3", rough_self_affine},
                                        {"honed", honed}};
  return all;
}

}  // namespace accuracy
