#include "draw.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "heights.h"
#include "matrices.h"
#include "oracle.h"

namespace scenes {

namespace {

enum Part : std::uint64_t { systems = 1, options, masks, heights, hardnesses, targets, matrices };

constexpr std::array<const char*, 5> boundary_names{"", "free", "periodic", "periodic-x", "periodic-y"};

// Every 64 seeds in a row have each boundary with each kind of control, with and without hardness and mask.
struct Cover {
  std::uint64_t k;
  explicit Cover(std::uint64_t seed) : k(seed % 64) {}
  bool hard() const { return k % 2 == 1; }
  bool masked() const { return k / 2 % 2 == 1; }
  bool by_load() const { return k / 4 % 2 == 1; }
  std::size_t boundary() const { return k / 8; }
};

void draw_sides(Random& random, rc_system& s, bool reduced, bool stored) {
  const auto shaped = [&](std::int64_t points) {
    s.nx = random.between(1, 16);
    s.ny = random.between(1, std::max<std::int64_t>(1, std::min<std::int64_t>(16, points / s.nx)));
  };
  const double kind = random.uniform();
  if (kind < 0.06) {  // a line
    s.nx = 1;
    s.ny = random.between(1, reduced ? 24 : 64);
  } else if (reduced || kind < 0.82) {
    shaped(reduced ? 36 : 64);
  } else if (kind < 0.95 || stored) {
    shaped(144);
  } else {
    constexpr std::array<std::int64_t, 12> sides{24, 31, 48, 60, 64, 65, 96, 100, 127, 128, 130, 160};
    do {
      s.nx = random.one_of(sides);
      s.ny = random.one_of(sides);
    } while (s.nx * s.ny > 128 * 128);
    if (random.chance(0.25)) {  // thin
      s.nx = random.between(1, 16);
      s.ny = random.between(301, 1200);
    }
  }
  if (random.chance(0.5)) std::swap(s.nx, s.ny);
}

void draw_system(const Cover& cover, bool reduced, Scene& scene) {
  Random random(scene.seed, systems);
  rc_system& s = scene.system;
  s = rc_system{};
  s.struct_size = sizeof s;
  // free twice, periodic twice, semi-periodic along either axis, a matrix, a matrix or a product
  constexpr std::array<std::int32_t, 8> operators{1, 2, 3, 4, 1, 2, -2, 0};
  const std::int32_t chosen = operators[cover.boundary()];
  const bool product = chosen == 0 && random.chance(0.5);
  s.op = chosen > 0 ? RC_OPERATOR_HALFSPACE : product ? RC_OPERATOR_CALLBACK : RC_OPERATOR_DENSE;
  s.boundary = std::max(chosen, 0);
  draw_sides(random, s, reduced, !scene.halfspace());
  if (scene.periodic() && s.nx * s.ny == 1) s.nx = 2;
  const double scale = random.decades(-6, 3), shape = random.uniform();
  s.hx = s.hy = scale;
  s.modulus = scene.halfspace() ? (random.chance(0.6) ? random.decades(-3, 11) : random.decades(-1, 1)) : 0;
  constexpr std::array<const char*, 6> free{"auto", "love", "galerkin", "disc", "punch", "eq9"};
  if (scene.halfspace())
    scene.kernel = random.chance(0.2)      ? "auto"
                   : scene.periodic()      ? "spectral"
                   : scene.semi_periodic() ? (random.chance(0.5) ? "love" : "spectral")
                                           : random.one_of(free);
  const bool square = scene.kernel == "disc" || scene.kernel == "punch" || scene.kernel == "eq9";
  if (!square && shape > 0.5) s.hy *= random.decades(shape > 0.85 ? -2 : -1, shape > 0.85 ? 2 : 1);
  if (scene.kernel == "galerkin") s.hy = std::clamp(s.hy, 0.1 * s.hx, 10 * s.hx);
  if (scene.halfspace()) return;
  Random entries(scene.seed, matrices);
  scene.matrix = random_matrix(scene.points(), entries);
}

void draw_options(const Cover& cover, Scene& scene) {
  Random random(scene.seed, options);
  scene.control = cover.by_load() ? (random.chance(0.75) ? RC_CONTROL_LOAD : RC_CONTROL_PRESSURE)
                                  : (random.chance(0.9) ? RC_CONTROL_APPROACH : RC_CONTROL_AREA);
  scene.tol = random.decades(-10, -4);
  constexpr std::array<const char*, 4> stiffnesses{"0", "1", "2", "2"};
  scene.settings = {{"tol", pairs::text(scene.tol)},
                    {"stiffness", random.one_of(stiffnesses)},
                    {"bounds", random.chance(0.9) ? "1" : "0"},
                    {"threads", std::to_string(random.between(1, 3))}};
  if (random.chance(0.3)) scene.settings.emplace_back("resumable", "1");
}

void draw_mask(const Cover& cover, Random& random, const rc_system& s, Surface& surface) {
  if (!cover.masked() || random.chance(0.3)) return;
  const std::size_t n = surface.gap.size();
  surface.mask.assign(n, 1);
  const double kind = random.uniform(), share = random.uniform();
  const double x = random.uniform() * static_cast<double>(s.nx), y = random.uniform() * static_cast<double>(s.ny),
               radius = 0.5 * share * static_cast<double>(std::max(s.nx, s.ny));
  for (std::size_t i = 0; i < n; ++i) {
    const auto ix = static_cast<double>(static_cast<std::int64_t>(i) % s.nx),
               iy = static_cast<double>(static_cast<std::int64_t>(i) / s.nx);
    const double r = std::hypot(ix - x, iy - y);
    const bool kept = kind < 0.4    ? !random.chance(share)                   // scattered
                      : kind < 0.55 ? r > radius                              // a hole
                      : kind < 0.7  ? r < radius                              // a disc
                      : kind < 0.8  ? ix < share * static_cast<double>(s.nx)  // a part
                      : kind < 0.95 ? random.chance(0.1)                      // single points
                                    : true;                                   // excludes nothing
    surface.mask[i] = kept;
  }
  surface.mask[static_cast<std::size_t>(random.below(static_cast<std::int64_t>(n)))] = 1;
  if (random.chance(0.6))
    for (std::size_t i = 0; i < n; ++i)
      if (!surface.mask[i]) surface.gap[i] = std::numeric_limits<double>::quiet_NaN();
}

// The displacement at which matters happen: that of a cell under a pressure of the modulus, or the matrix's entries.
double length_of(const Scene& scene) {
  if (scene.halfspace()) return std::sqrt(scene.system.hx * scene.system.hy);
  return *std::ranges::max_element(scene.matrix);
}

std::string draw_surfaces(const Cover& cover, Scene& scene) {
  Random random(scene.seed, heights), excluded(scene.seed, masks);
  const rc_system& s = scene.system;
  const std::int64_t count = random.chance(0.2) ? 2 : 1;
  const double size = length_of(scene) * random.decades(-5, 0.5), datum = random.chance(0.2) ? size * random.decades(-1, 3) : 0;
  std::string words;
  for (std::int64_t k = 0; k < count; ++k) {
    Heights made = random_heights(s.nx, s.ny, random);
    const auto [low, high] = std::ranges::minmax(made.z);
    const double range = high > low ? high - low : 1, sign = random.chance(0.2) ? -1 : 1, end = sign > 0 ? high : -low;
    Surface surface;
    for (const double z : made.z) surface.gap.push_back(size * (end - sign * z) / range + datum);
    draw_mask(cover, excluded, s, surface);
    scene.surfaces.push_back(surface);
    words += (k ? " and " : "") + made.family;
  }
  return words;
}

struct Levels {
  double lowest = HUGE_VAL, highest = -HUGE_VAL, mean = 0;
  bool whole = true;  // all points are included
};

Levels levels_of(const Surface& surface) {
  Levels levels;
  double count = 0;
  for (std::size_t i = 0; i < surface.gap.size(); ++i) {
    levels.whole = levels.whole && surface.included(i);
    if (!surface.included(i)) continue;
    levels.lowest = std::min(levels.lowest, surface.gap[i]);
    levels.highest = std::max(levels.highest, surface.gap[i]);
    levels.mean += surface.gap[i];
    ++count;
  }
  levels.mean /= count;
  return levels;
}

double draw_approach(Random& random, const Scene& scene, const Surface& surface) {
  const Levels levels = levels_of(surface);
  const double range = std::max(levels.highest - levels.lowest, 1e-3 * std::abs(levels.highest) + 1e-6 * length_of(scene));
  const double kind = random.uniform();
  if (scene.periodic() && levels.whole && !scene.hard()) {
    const double room = levels.mean - levels.lowest;
    if (!(room > 1e-9 * std::abs(levels.mean))) return levels.lowest - 0.5 * range;  // flat: nothing may touch
    const double share = kind < 0.2    ? random.decades(-4, -1)
                         : kind < 0.85 ? random.uniform(0.1, 0.9)
                                       : 1 - random.decades(-3, -1);
    return levels.lowest + share * room;
  }
  if (kind < 0.04) return levels.lowest - random.uniform(0, 1) * range;  // nothing touches
  if (kind < 0.07) return levels.lowest;
  if (kind < 0.25) return levels.lowest + random.decades(-4, -1) * range;
  if (kind < 0.8) return levels.lowest + random.uniform(0.1, 2) * range;
  return levels.lowest + random.decades(0, 1.5) * range;
}

// The load that is exact at an approach. For many points an estimate.
double load_at(const Scene& scene, const Influence* h, const Surface& surface, double approach) {
  if (h) {
    const Exact exact = exact_at(scene, *h, surface, {}, approach);
    if (exact.usable()) return static_cast<double>(exact.sum) * scene.cell_area();
  }
  double sum = 0;
  for (std::size_t i = 0; i < scene.points(); ++i)
    if (surface.included(i)) sum += std::max(0.0, approach - surface.gap[i]);
  const double side = std::sqrt(static_cast<double>(scene.points()) * scene.cell_area());
  const double load = sum / static_cast<double>(scene.points()) * side * (scene.halfspace() ? scene.system.modulus : 1);
  return scene.hard() ? std::min(load, 0.3 * scene.system.hardness * scene.cell_area()) : load;
}

double draw_target(Random& random, const Scene& scene, const Influence* h, const Surface& surface) {
  const double approach = draw_approach(random, scene, surface);
  if (scene.control == RC_CONTROL_APPROACH) return approach;
  const double cells = static_cast<double>(scene.points()) * scene.cell_area();
  if (scene.control == RC_CONTROL_AREA)
    return std::round(random.uniform(0.05, 0.9) * static_cast<double>(scene.points())) * scene.cell_area();
  double load = load_at(scene, h, surface, approach);
  if (scene.hard() && random.chance(0.2)) {
    double included = 0;
    for (std::size_t i = 0; i < scene.points(); ++i) included += surface.included(i);
    constexpr std::array<double, 5> shares{1e-6, 0.5, 0.9999, 1 - 1e-9, 1};
    load = scene.system.hardness * scene.cell_area() * included * random.one_of(shares);
  } else if (scene.periodic() && !scene.hard() && random.chance(0.15)) {
    load *= random.decades(0, 2);  // into full contact
  } else if (random.chance(0.03)) {
    load = 0;
  }
  return scene.control == RC_CONTROL_PRESSURE ? load / cells : load;
}

void draw_hardness(const Cover& cover, Scene& scene, const Influence* h) {
  if (!cover.hard()) return;
  Random random(scene.seed, hardnesses);
  if (random.chance(0.1)) return;
  const Surface& surface = scene.surfaces.front();
  const Levels levels = levels_of(surface);
  const double range = std::max(levels.highest - levels.lowest, 1e-3 * length_of(scene));
  const double row = h ? static_cast<double>((*h)(0, 0)) : length_of(scene) / scene.system.modulus;
  double hardness = range / row * random.decades(-1.5, 0.5);
  if (h && random.chance(0.4)) {  // part of the largest elastic pressure
    const Exact elastic = exact_at(scene, *h, surface, {}, draw_approach(random, scene, surface));
    if (elastic.usable() && elastic.sum > 0)
      hardness = static_cast<double>(*std::ranges::max_element(elastic.p)) * random.uniform(0.3, 0.95);
  }
  scene.system.hardness = random.chance(0.03)   ? std::numeric_limits<double>::infinity()
                          : random.chance(0.03) ? 1e6 * hardness
                                                : hardness;
}

// Zeros, one pressure everywhere, noise, or far too much.
Field draw_start(Random& random, const Scene& scene, const Influence* h) {
  const double row = h ? static_cast<double>((*h)(0, 0)) : length_of(scene) / scene.system.modulus;
  const double size = scene.hard() ? scene.system.hardness : scene.surfaces.front().gap.size() * 1e-3 * length_of(scene) / row;
  const std::int64_t kind = random.below(4);
  Field p0(scene.points(), kind == 0 ? 0.0 : size * (kind == 3 ? 1e4 : 0.1));
  if (kind == 2)
    for (double& p : p0) p *= random.uniform(-0.2, 2);
  return p0;
}

// Approaches change by their distance from first touch, and stay below the mean plane where they must.
double changed_target(const Scene& scene, double target, double factor) {
  if (scene.control != RC_CONTROL_APPROACH) return factor * target;
  const Levels levels = levels_of(scene.surfaces.front());
  const double most = scene.periodic() && levels.whole && !scene.hard() ? 0.999 * (levels.mean - levels.lowest) : HUGE_VAL;
  return levels.lowest + std::min(factor * (target - levels.lowest), most);
}

void draw_steps(Scene& scene, const Influence* h) {
  Random random(scene.seed, targets);
  const double kind = random.uniform();
  const bool many = kind > 0.99 && !scene.large() && scene.surfaces.size() == 1;
  const std::int64_t count = scene.large() ? random.between(1, 2)
                             : many        ? 40
                             : kind < 0.4  ? 1
                             : kind < 0.85 ? random.between(2, 4)
                                           : random.between(5, 8);
  const bool small_changes = many || random.chance(0.2), always_cold = random.chance(0.15), starts = random.chance(0.2);
  for (std::int64_t k = 0; k < count; ++k) {
    Step step;
    step.surface = scene.surfaces.size() > 1 && random.chance(0.4) ? 1 : 0;
    step.warm = !always_cold;
    if (small_changes && k > 0 && scene.surfaces.size() == 1 && !random.chance(0.1))
      step.target = changed_target(scene, scene.steps.back().target, 1 + (many ? 0.05 : 1e-3) * random.uniform(-1, 1));
    else
      step.target = draw_target(random, scene, h, scene.surfaces[step.surface]);
    if (starts && !scene.large() && random.chance(0.5)) step.p0 = draw_start(random, scene, h);
    scene.steps.push_back(step);
  }
}

std::string describe(const Scene& scene, const std::string& surfaces) {
  const rc_system& s = scene.system;
  const char* control = scene.control == RC_CONTROL_LOAD       ? "load"
                        : scene.control == RC_CONTROL_PRESSURE ? "mean pressure"
                        : scene.control == RC_CONTROL_AREA     ? "area"
                                                               : "approach";
  return std::string(scene.halfspace()           ? boundary_names[static_cast<std::size_t>(s.boundary)]
                     : s.op == RC_OPERATOR_DENSE ? "matrix"
                                                 : "product") +
         " " + std::to_string(s.nx) + " x " + std::to_string(s.ny) + ", cells " + pairs::text(s.hx) + " x " + pairs::text(s.hy) +
         (scene.halfspace() ? ", kernel " + scene.kernel + ", modulus " + pairs::text(s.modulus) : "") +
         (scene.hard() ? ", hardness " + pairs::text(s.hardness) : "") + (scene.surfaces.front().mask.empty() ? "" : ", mask") +
         ", " + surfaces + ", " + std::to_string(scene.steps.size()) + " steps by " + control +
         (scene.steps.front().warm ? "" : ", each cold") + ", tol " + pairs::text(scene.tol);
}

}  // namespace

Scene draw(std::uint64_t seed, bool reduced) {
  const Cover cover(seed);
  Scene scene;
  scene.seed = seed;
  draw_system(cover, reduced, scene);
  draw_options(cover, scene);
  const std::string surfaces = draw_surfaces(cover, scene);
  std::optional<Influence> h;
  if (!scene.large()) h.emplace(scene);
  draw_hardness(cover, scene, h ? &*h : nullptr);
  draw_steps(scene, h ? &*h : nullptr);
  scene.words = describe(scene, surfaces);
  return scene;
}

}  // namespace scenes
