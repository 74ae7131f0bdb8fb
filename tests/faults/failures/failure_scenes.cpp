#include "failure_scenes.h"

#include <roughcontact/registry.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "rough_surface.h"

namespace failures {

namespace {

// One step of splitmix64 (Steele, Lea & Flood 2014): the same numbers everywhere.
struct Uniform {
  std::uint64_t state;
  double operator()() {
    std::uint64_t z = state += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return std::ldexp(static_cast<double>((z ^ (z >> 31)) >> 11) + 0.5, -53);
  }
};

Scene on_grid(const char* name, std::int64_t n) {
  Scene scene;
  scene.name = name;
  scene.system.nx = scene.system.ny = n;
  return scene;
}

std::int64_t power_of_two(std::int64_t n) {
  std::int64_t levels = 0;
  while ((std::int64_t{1} << levels) < n) ++levels;
  return levels;
}

}  // namespace

rc_step Scene::step() const {
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_APPROACH;
  step.target = approach;
  step.undeformed_gap.data = gap.data();
  step.mask.data = mask.empty() ? nullptr : mask.data();
  return step;
}

Scene example_one(std::int64_t side, std::int64_t spacing, std::uint64_t seed) {
  const std::int64_t width = spacing * (side - 1) + 1;
  Scene scene = on_grid("example 1", width);
  scene.approach = 1;
  scene.gap.assign(static_cast<std::size_t>(width * width), 2.0);
  if (spacing > 1) scene.mask.assign(scene.gap.size(), 0);
  Uniform uniform{seed * 0x2545f4914f6cdd1d + 1};
  for (std::int64_t iy = 0; iy < side; ++iy)
    for (std::int64_t ix = 0; ix < side; ++ix) {
      const auto i = static_cast<std::size_t>(spacing * (iy * width + ix));
      scene.gap[i] = 1 - uniform();
      if (spacing > 1) scene.mask[i] = 1;
    }
  return scene;
}

Scene hertz_scene(std::int64_t n) {
  Scene scene = on_grid("Hertz", n);
  const double middle = 0.5 * static_cast<double>(n - 1), radius = static_cast<double>(n);
  for (std::int64_t iy = 0; iy < n; ++iy)
    for (std::int64_t ix = 0; ix < n; ++ix) {
      const double x = static_cast<double>(ix) - middle, y = static_cast<double>(iy) - middle;
      scene.gap.push_back((x * x + y * y) / (2 * radius));
    }
  scene.approach = radius / 9;
  return scene;
}

Scene rough_scene(std::int64_t levels, std::uint64_t seed, double hurst) {
  Scene scene = on_grid("rough", std::int64_t{1} << levels);
  scene.gap = gap_below_highest(midpoint_surface(levels, hurst, seed));
  scene.approach = mean_of(scene.gap) / 2;
  return scene;
}

Scene tied_scene(std::int64_t n) {
  Scene scene = on_grid("ties", n);
  std::vector<double> table(static_cast<std::size_t>(n * n));
  if (rc_kernel_coefficients(scene.kernel.c_str(), 1, 1, n, n, table.data()) != RC_OK) throw std::runtime_error(rc_last_error());
  Uniform uniform{1};
  const std::size_t points = table.size();
  Field p(points, 0.0);
  for (double& value : p)
    if (uniform() < 0.4) value = 0.5 + uniform();
  for (std::int64_t i = 0; i < n * n; ++i) {
    double u = 0;
    for (std::int64_t j = 0; j < n * n; ++j) {
      const auto offset = std::abs(i / n - j / n) * n + std::abs(i % n - j % n);
      u += table[static_cast<std::size_t>(offset)] * p[static_cast<std::size_t>(j)];
    }
    // A third of the points without pressure touch all the same.
    if (p[static_cast<std::size_t>(i)] == 0 && uniform() < 2.0 / 3) u -= 0.1 + uniform();
    scene.gap.push_back(-u);
  }
  const double lowest = *std::min_element(scene.gap.begin(), scene.gap.end());
  for (double& value : scene.gap) value -= lowest;
  scene.approach = -lowest;
  return scene;
}

Scene in_units(Scene scene, double length, double pressure) {
  scene.system.hx *= length;
  scene.system.hy *= length;
  scene.system.modulus *= pressure;
  scene.approach *= length;
  for (double& value : scene.gap) value *= length;
  return scene;
}

std::vector<Scene> strained_scenes(std::int64_t n) {
  const Scene rough = rough_scene(power_of_two(n), 3);
  const double highest = *std::max_element(rough.gap.begin(), rough.gap.end());
  std::vector<Scene> scenes;
  const auto add = [&](const char* name, Scene scene) -> Scene& {
    scene.name = name;
    scenes.push_back(std::move(scene));
    return scenes.back();
  };
  add("rough, kernel eq9", rough).kernel = "eq9";
  add("nearly every point in contact", rough).approach = 40 * highest;
  {
    Scene& scene = add("one point touches", rough);
    Field sorted = rough.gap;
    std::nth_element(sorted.begin(), sorted.begin() + 1, sorted.end());
    scene.approach = 0.5 * sorted[1];
  }
  {
    Scene& scene = add("a spike of 1e3 times the roughness", rough);
    for (double& value : scene.gap) value += 1e3 * highest;
    scene.gap[scene.gap.size() / 2 + 5] = 0;
    scene.approach = 1e3 * highest + rough.approach;
  }
  {
    Scene& scene = add("heights around 1e6 times the roughness", rough);
    for (double& value : scene.gap) value += 1e6 * highest;
    scene.approach = 1e6 * highest + rough.approach;
  }
  {
    Scene& scene = add("flat but for 1e-9 of the approach", rough);
    for (double& value : scene.gap) value *= 1e-9 / highest;
    scene.approach = 1;
  }
  add("cells 100 times as long as wide", rough).system.hx = 100;
  return scenes;
}

}  // namespace failures
