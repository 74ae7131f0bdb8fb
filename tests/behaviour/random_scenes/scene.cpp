#include "scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "scenes/heights.h"
#include "support/registry.h"

namespace scenes {

namespace {

using pairs::text;

constexpr std::int64_t most_for_stored = 1500;  // points, for backends that may store H

std::int64_t random_side(Random& random) {
  constexpr std::array<std::int64_t, 12> awkward{11, 13, 17, 27, 31, 37, 41, 53, 61, 75, 81, 97};
  const double size = random.uniform();
  if (size < 0.45) return random.between(8, 24);
  if (size < 0.62) return random.one_of(awkward);
  if (size < 0.96) return random.between(25, 64);
  return random.between(65, 128);
}

void random_shape(rc_system& s, Random& random) {
  const double kind = random.uniform();
  if (kind < 0.006) {
    s.nx = random.chance(0.4) ? 256 : random.between(129, 256);
    s.ny = random.chance(0.4) ? 256 : random.between(129, 256);
  } else if (kind < 0.05) {  // a line
    s.nx = 1;
    s.ny = random.between(8, 256);
  } else if (kind < 0.12) {  // a strip
    s.nx = random.between(2, 12);
    s.ny = random.between(64, 256);
  } else if (kind < 0.14) {
    s.nx = random.between(1, 7);
    s.ny = random.between(1, 7);
  } else if (kind < 0.4) {
    s.nx = s.ny = std::int64_t{8} << random.below(4);
  } else {
    s.nx = random_side(random);
    s.ny = random.chance(0.3) ? s.nx : random_side(random);
  }
  if (random.chance(0.5)) std::swap(s.nx, s.ny);
}

// Kernels that the library lists and takes for these boundaries and cells.
std::vector<std::string> fitting_kernels(const rc_system& system) {
  std::vector<std::string> result;
  rc_system small = system;
  small.nx = small.ny = 2;
  for (const std::string& kernel : pairs::kernel_names()) {
    const pairs::Options options = pairs::make_options(pairs::automatic, kernel);
    rc_contact* contact = nullptr;
    if (rc_contact_create(&small, options.get(), &contact) == RC_OK) result.push_back(kernel);
    rc_contact_destroy(contact);
  }
  return result;
}

// The production pair mostly, what the library chooses, and the solver on every other backend.
pairs::Pair random_pair(const rc_system& system, Random& random) {
  const double share = random.uniform();
  const pairs::Pair production{"haar-cg", "fft"};
  if (share < 0.7) return production;
  if (share < 0.9 || system.nx * system.ny > most_for_stored) return pairs::automatic;
  std::vector<pairs::Pair> others;
  for (const std::string& backend : pairs::backend_names()) {
    const pairs::Pair pair{"haar-cg", backend};
    if (backend == "split" && std::abs(std::log2(system.hy / system.hx)) > 1.99) continue;  // which it refuses
    if (pairs::obstacle(pair, system, RC_CONTROL_APPROACH).empty()) others.push_back(pair);
  }
  return others.empty() ? production : random.one_of(others);
}

std::vector<std::uint8_t> random_mask(const rc_system& s, Random& random) {
  const std::int64_t kind = random.below(4);
  const double share = random.uniform(0.02, 0.9), side = static_cast<double>(std::min(s.nx, s.ny));
  const double inner = random.uniform(0, 0.4) * side, outer = inner + random.uniform(0.1, 0.6) * side + 1;
  const double x = random.uniform() * static_cast<double>(s.nx), y = random.uniform() * static_cast<double>(s.ny);
  std::vector<std::uint8_t> mask;
  for (std::int64_t iy = 0; iy < s.ny; ++iy)
    for (std::int64_t ix = 0; ix < s.nx; ++ix) {
      const double r = std::hypot(static_cast<double>(ix) - x, static_cast<double>(iy) - y);
      const bool in = kind == 0   ? random.uniform() >= share
                      : kind == 1 ? r >= inner && r <= outer
                      : kind == 2 ? iy >= s.ny / 2 || s.ny == 1
                                  : r > inner;  // one hole
      mask.push_back(in ? 1 : 0);
    }
  mask[static_cast<std::size_t>(random.below(s.nx * s.ny))] = 1;
  return mask;
}

struct Levels {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest, mean = 0;
  bool whole = true;
  double range() const { return highest - lowest; }
};

Levels levels_of(const pairs::Problem& problem) {
  Levels levels;
  double total = 0, count = 0;
  for (std::size_t i = 0; i < problem.gap.size(); ++i) {
    if (!problem.included(i)) {
      levels.whole = false;
      continue;
    }
    levels.lowest = std::min(levels.lowest, problem.gap[i]);
    levels.highest = std::max(levels.highest, problem.gap[i]);
    total += problem.gap[i];
    ++count;
  }
  levels.mean = total / count;
  return levels;
}

// From the first touch, over four decades, to far beyond full contact; with periodic boundaries as near to the mean plane as the
// gap left in the pits is still a number.
double random_approach(const Levels& levels, bool periodic, double unit, Random& random) {
  if (random.chance(0.01)) return levels.lowest - (random.chance(0.5) ? 0 : unit);
  const double range = levels.range() > 0 ? levels.range() : unit;
  if (periodic && levels.whole) {
    const double depth = levels.mean - levels.lowest;
    if (!(depth > 1e-9 * std::max(std::abs(levels.lowest), range))) return levels.lowest - unit;
    return levels.lowest + depth * (random.chance(0.25) ? 1 - random.decades(-6, -1) : random.decades(-4, 0) * 0.999);
  }
  return levels.lowest + range * (random.chance(0.15) ? random.decades(0, 2) : random.decades(-4, 0));
}

// Full contact of a periodic surface takes up to about E* times its steepest slope.
double random_load(const Levels& levels, const pairs::Problem& problem, double unit, Random& random) {
  const rc_system& s = problem.system;
  if (random.chance(0.01)) return 0;
  const double range = levels.range() > 0 ? levels.range() : unit;
  const double full = s.modulus * range / std::min(s.hx, s.hy) * static_cast<double>(s.nx * s.ny) * s.hx * s.hy;
  return full * (random.chance(0.15) ? random.decades(0, 4) : random.decades(-7, 0));
}

void add_surface(Step& step, pairs::Problem& problem, double unit, Random& random) {
  const rc_system& s = problem.system;
  const Heights heights = random_heights(s.nx, s.ny, random);
  const auto [low, high] = std::ranges::minmax(heights.z);
  const double scale = unit / (high > low ? high - low : 1), datum = random.chance(0.2) ? unit * random.normal() : 0;
  problem.gap.clear();
  for (const double z : heights.z) problem.gap.push_back((high - z) * scale + datum);
  problem.mask.clear();
  if (random.chance(0.15)) {
    problem.mask = random_mask(s, random);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const bool undefined = random.chance(0.3);
    for (std::size_t i = 0; i < problem.gap.size(); ++i)
      if (undefined && !problem.included(i)) problem.gap[i] = nan;
  }
  step.gap = problem.gap;
  step.mask = problem.mask;
  step.surface = heights.family + (problem.mask.empty() ? "" : ", masked");
}

void make_infeasible(Step& step, const Levels& levels, bool periodic, double unit, Random& random) {
  step.expected = RC_ERR_INFEASIBLE;
  if (periodic && levels.whole && random.chance(0.5)) {
    step.control = RC_CONTROL_APPROACH;
    step.target = levels.mean + unit * random.uniform(0.01, 10);
  } else {
    step.control = RC_CONTROL_LOAD;
    step.target = -unit;
  }
}

}  // namespace

Scene random_scene(std::uint64_t seed, std::uint64_t number) {
  Random random(seed, number);
  Scene scene;
  scene.number = number;
  pairs::Problem& problem = scene.problem;
  rc_system& s = problem.system;
  random_shape(s, random);
  const bool periodic = random.chance(0.4);
  s.boundary = periodic ? RC_BOUNDARY_PERIODIC : RC_BOUNDARY_FREE;
  s.modulus = random.decades(-3, 11);
  s.hx = s.hy = random.decades(-1, 1);
  if (random.chance(0.3)) s.hy = random.decades(-1, 1);
  scene.pair = random_pair(s, random);
  problem.kernel = random.chance(0.2) ? "auto" : random.one_of(fitting_kernels(s));
  const double tolerance = random.uniform();
  scene.tol = tolerance < 0.76 ? 1e-8 : tolerance < 0.84 ? 1e-4 : tolerance < 0.92 ? 1e-6 : 1e-10;
  scene.name = scene.pair.name() + " " + problem.kernel + (periodic ? " periodic " : " free ") + std::to_string(s.nx) + "x" +
               std::to_string(s.ny) + " hy/hx " + text(s.hy / s.hx) + " tol " + text(scene.tol);

  const double unit = random.decades(-9, 3);  // height of the surfaces
  const std::int64_t steps = random.chance(0.4) ? 1 : random.between(2, 4);
  std::string surface;
  for (std::int64_t k = 0; k < steps; ++k) {
    Step step;
    if (k == 0 || random.chance(0.3)) add_surface(step, problem, unit, random);
    surface = step.gap.empty() ? surface : step.surface;
    const Levels levels = levels_of(problem);
    step.control = random.chance(0.5) ? RC_CONTROL_LOAD : RC_CONTROL_APPROACH;
    step.target = step.control == RC_CONTROL_LOAD ? random_load(levels, problem, unit, random)
                                                  : random_approach(levels, periodic, unit, random);
    if (random.chance(0.01)) make_infeasible(step, levels, periodic, unit, random);
    step.warm = random.chance(0.85);
    if (random.chance(0.3)) {
      step.start.kind = static_cast<Start::Kind>(random.between(Start::random, Start::single_cell));
      step.start.seed = number;
      step.start.size = s.modulus * unit / std::sqrt(s.hx * s.hy) * random.decades(-3, 1);
    }
    constexpr const char* starts[] = {"",           " from random",  " from a checkerboard", " from 50 times too much",
                                      " from zero", " from one cell"};
    step.name = "step " + std::to_string(k) + " (" + surface + (step.control == RC_CONTROL_LOAD ? ", load " : ", approach ") +
                text(step.target) + (k > 0 && !step.warm ? " cold" : "") + starts[step.start.kind] + ")";
    scene.steps.push_back(std::move(step));
  }
  problem.gap = scene.steps.front().gap;
  problem.mask = scene.steps.front().mask;
  return scene;
}

std::optional<Field> start_pressures(const Start& start, const pairs::Problem& problem, const Field& last) {
  if (start.kind == Start::remembered) return std::nullopt;
  const std::int64_t nx = problem.system.nx;
  Random random(start.seed, 1);
  Field p(problem.points(), 0.0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const std::int64_t x = static_cast<std::int64_t>(i) % nx, y = static_cast<std::int64_t>(i) / nx;
    switch (start.kind) {
      case Start::random:  // some of them negative
        p[i] = start.size * random.uniform(-0.5, 1);
        break;
      case Start::checkerboard:
        p[i] = (x + y) % 2 == 0 ? start.size : 0;
        break;
      case Start::too_large:
        p[i] = 50 * (last.empty() ? start.size : last[i]);
        break;
      default:
        break;
    }
  }
  if (start.kind == Start::single_cell)
    p[static_cast<std::size_t>(random.below(static_cast<std::int64_t>(p.size())))] = start.size;
  return p;
}

}  // namespace scenes
