// Cells or surfaces that are much longer than wide: haar-cg takes hardly more products than plain conjugate gradients.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "support/contact.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

constexpr double most = 1.5;        // products of haar-cg over those of polonsky-keer; near a stall processors differ by a third
constexpr std::int64_t spare = 15;  // products by which small counts may differ

std::int64_t products(const Problem& problem, const char* solver) {
  return solved(problem, {solver, "fft"}, {{RC_OPT_TOL, "1e-6"}}).result.products;
}

void check_products(const Problem& problem, const std::string& what) {
  const std::int64_t ours = products(problem, "haar-cg"), plain = products(problem, "polonsky-keer");
  report(what + ": products " + std::to_string(ours) + ", polonsky-keer " + std::to_string(plain));
  check(static_cast<double>(ours) <= most * static_cast<double>(plain) + spare, "too many products");
}

// Waves, as many along a side as across, with noise on every cell.
Problem rugged(std::int64_t nx, std::int64_t ny, double hy, std::int32_t boundary, double depth) {
  Problem problem = rough_problem(nx, ny, boundary, 1, hy);
  unsigned state = 5;
  for (double& gap : problem.gap) {
    state = state * 1664525U + 1013904223U;
    gap += 0.1 * static_cast<double>(state >> 8) / (1 << 24);
  }
  const double mean = sum(problem.gap) / static_cast<double>(problem.points()), lowest = problem.lowest_gap();
  problem.target = lowest + depth * (mean - lowest);
  return problem;
}

// Waves of all lengths along both sides, in cells, with random phases; the higher the shorter waves count for less.
Problem self_affine(std::int64_t nx, std::int64_t ny, double hy, double hurst, double depth) {
  Problem problem = rough_problem(nx, ny, RC_BOUNDARY_PERIODIC, 1, hy);
  std::mt19937 random(7);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  Field heights(problem.points(), 0.0);
  constexpr double turn = 2 * std::numbers::pi;
  for (int wave = 0; wave < 400; ++wave) {
    const double across = std::floor(uniform() * static_cast<double>(nx) / 3),
                 along = std::floor((2 * uniform() - 1) * static_cast<double>(ny) / 3);
    const double length = std::hypot(across / static_cast<double>(nx), along / static_cast<double>(ny)), phase = turn * uniform();
    if (length == 0) continue;
    const double size = std::pow(std::max(length, 4.0 / static_cast<double>(std::max(nx, ny))), -0.5 - hurst);
    for (std::int64_t y = 0; y < ny; ++y)
      for (std::int64_t x = 0; x < nx; ++x)
        heights[static_cast<std::size_t>(y * nx + x)] +=
            size * std::cos(phase + turn * (across * static_cast<double>(x) / static_cast<double>(nx) +
                                            along * static_cast<double>(y) / static_cast<double>(ny)));
  }
  const double highest = *std::max_element(heights.begin(), heights.end());
  for (std::size_t i = 0; i < heights.size(); ++i) problem.gap[i] = highest - heights[i];
  problem.target = depth * sum(problem.gap) / static_cast<double>(problem.points());
  return problem;
}

void approaches_of_elongated_periodic_surfaces() {
  for (const double depth : {0.3, 0.5, 0.8}) {
    check_products(self_affine(128, 64, 60, 0.8, depth), "128 x 64, hy = 60 hx");
    check_products(self_affine(37, 100, 0.026, 0.5, depth), "37 x 100, hy = 0.026 hx");
    check_products(self_affine(96, 96, 61, 0.6, depth), "96 x 96, hy = 61 hx");
  }
}

// One point stands out: coarser grids, which average over it, find an approach that is much too large.
void a_load_on_one_point(std::int32_t boundary, double hy) {
  Problem problem = rugged(256, 256, hy, boundary, 0);
  const std::size_t peak = 100 * 256 + 77;
  problem.gap[peak] = problem.lowest_gap() - 3;
  check_products(at_load(problem, 1e-3), "one point carries the load");
}

void loads_on_one_point() {
  a_load_on_one_point(RC_BOUNDARY_PERIODIC, 0.026);
  a_load_on_one_point(RC_BOUNDARY_FREE, 30);
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  return run_group("solvers.elongated",
                   {{"approaches_of_elongated_periodic_surfaces", approaches_of_elongated_periodic_surfaces},
                    {"loads_on_one_point", loads_on_one_point}},
                   argc, argv);
}
