#include "odd_scene.h"

#include <algorithm>
#include <cmath>

#include "scenes/heights.h"

namespace scenes {

namespace {

// A few in a hundred are as large as a test can afford.
std::int64_t odd_side(Random& random) {
  const double size = random.uniform();
  return size < 0.5 ? random.between(5, 64) : size < 0.93 ? random.between(65, 160) : random.between(161, 300);
}

void odd_shape(rc_system& s, Random& random) {
  const double kind = random.uniform();
  if (kind < 0.25) {  // thin
    s.nx = random.between(1, 16);
    s.ny = random.chance(0.9) ? random.between(64, 600) : random.between(601, 2500);
  } else if (kind < 0.45) {
    s.nx = s.ny = std::int64_t{16} << random.below(5);
  } else {
    s.nx = odd_side(random);
    s.ny = odd_side(random);
  }
  if (random.chance(0.5)) std::swap(s.nx, s.ny);
  if (random.chance(0.75)) s.hy = random.decades(-2, 2);
}

// The shares of depth or load that leave only a few points, an ordinary contact, or hardly a gap.
double odd_share(Random& random) {
  const double kind = random.uniform();
  return kind < 0.25 ? random.decades(-4, -1) : kind < 0.6 ? random.uniform(0.1, 0.9) : 1 - random.decades(-5, -1);
}

}  // namespace

OddScene odd_scene(std::uint64_t seed, std::uint64_t number) {
  Random random(seed, number);
  OddScene scene;
  pairs::Problem& problem = scene.problem;
  rc_system& s = problem.system;
  odd_shape(s, random);
  const bool periodic = random.chance(0.6), load = random.chance(0.5);
  s.boundary = periodic ? RC_BOUNDARY_PERIODIC : RC_BOUNDARY_FREE;
  scene.tol = random.chance(0.5) ? 1e-6 : 1e-8;

  Heights heights = random_heights(s.nx, s.ny, random);
  const auto [low, high] = std::ranges::minmax(heights.z);
  const double range = high > low ? high - low : 1;
  double top = high;
  const bool peak = random.chance(0.25);  // one point stands out
  if (peak) {
    top = high + range * random.decades(-1, 2);
    heights.z[static_cast<std::size_t>(random.below(s.nx * s.ny))] = top;
  }
  double mean = 0;
  for (const double z : heights.z) {
    problem.gap.push_back((top - z) / range);
    mean += problem.gap.back() / static_cast<double>(heights.z.size());
  }
  const double share = odd_share(random);
  if (load) {
    problem.control = RC_CONTROL_LOAD;
    // About the load that flattens the heights, or presses on the one point.
    const double full = s.modulus / std::min(s.hx, s.hy) * static_cast<double>(s.nx * s.ny) * s.hx * s.hy;
    problem.target = full * (share < 0.9 ? 0.5 * share : random.decades(-1, 1)) * (peak ? random.decades(-5, 0) : 1);
  } else {
    const double deepest = periodic ? mean : *std::ranges::max_element(problem.gap) * (share > 0.9 ? random.decades(0, 1) : 1);
    problem.target = share * deepest;
  }
  scene.name = std::string(periodic ? "periodic " : "free ") + std::to_string(s.nx) + "x" + std::to_string(s.ny) + " hy/hx " +
               pairs::text(s.hy / s.hx) + " " + heights.family + (peak ? ", one peak" : "") + (load ? ", load " : ", approach ") +
               pairs::text(problem.target) + " tol " + pairs::text(scene.tol);
  return scene;
}

}  // namespace scenes
