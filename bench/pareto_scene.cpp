#include "pareto_scene.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>

#include "measured_surface.h"
#include "rough_surface.h"
#include "truth.h"

namespace bench {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double height = 0.01;  // of waves, and the depth of the punch
constexpr double hurst_exponents[] = {0.3, 0.5, 0.7, 0.9};

struct Measured {
  const char *name, *file;  // below the folder of measured surfaces
};
constexpr Measured measured_surfaces[] = {{"afm_film", "measured/afm_film_10um.gsf"},
                                          {"afm_selfaffine", "measured/afm_selfaffine_10um.gsf"},
                                          {"afm_patch", "measured/afm_patch_10um.gsf"},
                                          {"confocal_lay", "measured/confocal_lay_1275um.gsf"},
                                          {"fv_rubber", "measured-lgpl/fv_rubber_2mm.gsf"}};

std::string rmd_name(double hurst) { return "rmd-0." + std::to_string(std::lround(10 * hurst)); }

// Values at the centres of n x n cells, as a function of both coordinates.
template <class Value> Field sampled(std::int64_t n, const Value& value) {
  Field field;
  field.reserve(static_cast<std::size_t>(n * n));
  const auto at = [n](std::int64_t i) { return (static_cast<double>(i) + 0.5) / static_cast<double>(n); };
  for (std::int64_t iy = 0; iy < n; ++iy)
    for (std::int64_t ix = 0; ix < n; ++ix) field.push_back(value(at(ix), at(iy)));
  return field;
}

ParetoScene hertz() {
  ParetoScene scene;
  scene.most_contact = 0.5;  // the disc has to fit into the square
  scene.gap = [](std::int64_t n) { return Hertz().gap(n); };
  scene.known = [](double contact) {
    const Hertz sphere{std::sqrt(contact / pi)};
    return KnownContact{sphere.approach(), sphere.load(), sphere.contact_area(),
                        [sphere](std::int64_t n) { return sphere.pressure(n); }};
  };
  return scene;
}

// One wave of height 2 x `height`: Westergaard (1939) in the form of Johnson (1985), 13.2. The approach, measured between mean
// planes, follows from dd/dp = 2/(pi E*) ln(1/s), the field of a periodic row of flat strips, and p = pi E* height s^2.
ParetoScene wave() {
  ParetoScene scene;
  scene.boundary = RC_BOUNDARY_PERIODIC;
  scene.gap = [](std::int64_t n) {
    return sampled(n, [](double x, double) { return height * (1 - std::cos(2 * pi * (x - 0.5))); });
  };
  scene.known = [](double contact) {
    const double s = std::sin(pi * contact / 2), load = pi * height * s * s;
    const auto pressure = [s, load](double x, double) {
      const double sine = std::sin(pi * (x - 0.5)), square = s * s - sine * sine;
      return square > 0 ? 2 * load / (s * s) * std::cos(pi * (x - 0.5)) * std::sqrt(square) : 0.0;
    };
    return KnownContact{height * s * s * (1 - 2 * std::log(s)), load, contact,
                        [pressure](std::int64_t n) { return sampled(n, pressure); }};
  };
  return scene;
}

// The product of two waves, pressed flat by 1.2 times the load that it takes: Johnson, Greenwood & Higginson (1985).
ParetoScene waves() {
  const auto shape = [](double x, double y) { return std::cos(2 * pi * x) * std::cos(2 * pi * y); };
  ParetoScene scene;
  scene.boundary = RC_BOUNDARY_PERIODIC;
  scene.control = RC_CONTROL_LOAD;  // flat, the approach no longer tells the load
  scene.full = true;
  scene.gap = [shape](std::int64_t n) { return sampled(n, [&](double x, double y) { return height * (1 - shape(x, y)); }); };
  scene.known = [shape](double) {
    const double amplitude = std::numbers::sqrt2 * pi * height, load = 1.2 * amplitude;
    return KnownContact{load, load, 1, [=](std::int64_t n) {
                          return sampled(n, [&](double x, double y) { return load + amplitude * shape(x, y); });
                        }};
  };
  return scene;
}

// A flat square punch that covers the grid: load = pi E* depth C, C = 0.36679 the capacity of the unit square (Read 1997).
ParetoScene punch() {
  constexpr double capacity = 0.36679;
  ParetoScene scene;
  scene.full = true;
  scene.gap = [](std::int64_t n) { return Field(static_cast<std::size_t>(n * n)); };
  scene.known = [](double) { return KnownContact{height, pi * capacity * height, 1, nullptr}; };
  return scene;
}

ParetoScene self_affine(std::int64_t n, std::uint64_t seed) {
  ParetoScene scene;
  SelfAffine surface;
  surface.seed = seed;
  surface.cut_off = static_cast<double>(n) / 8;
  scene.gap = [surface](std::int64_t points) { return self_affine_gap(points, surface); };
  return scene;
}

// Heights are made on the finest grid; the others have means over blocks of its cells.
ParetoScene midpoint(std::int64_t n, double hurst, std::uint64_t seed) {
  ParetoScene scene;
  scene.gap = [finest = 4 * n, hurst, seed](std::int64_t points) {
    return block_means(gap_below_highest(midpoint_surface(std::countr_zero(static_cast<std::uint64_t>(finest)), hurst, seed)),
                       finest, points);
  };
  return scene;
}

// The largest square of a power of two points, from the middle.
ParetoScene measured(const std::string& file) {
  const MeasuredSurface surface = read_measured(file);
  const auto side = static_cast<std::int64_t>(std::bit_floor(static_cast<std::uint64_t>(std::min(surface.nx, surface.ny))));
  const std::int64_t left = (surface.nx - side) / 2, top = (surface.ny - side) / 2;
  Field heights;
  heights.reserve(static_cast<std::size_t>(side * side));
  for (std::int64_t iy = 0; iy < side; ++iy)
    for (std::int64_t ix = 0; ix < side; ++ix)
      heights.push_back(surface.heights[static_cast<std::size_t>((top + iy) * surface.nx + left + ix)] /
                        (static_cast<double>(side) * surface.hx));
  ParetoScene scene;
  scene.n = side / 4;
  scene.aspect = surface.hy / surface.hx;
  scene.gap = [side, gap = std::make_shared<const Field>(gap_below_highest(heights))](std::int64_t points) {
    return block_means(*gap, side, points);
  };
  return scene;
}

}  // namespace

rc_system ParetoScene::system(std::int64_t points) const {
  rc_system system = unit_square(points);
  system.hy *= aspect;
  system.boundary = boundary;
  return system;
}

std::vector<std::string> pareto_scene_names() {
  std::vector<std::string> names = {"hertz", "wave", "waves", "punch", "self-affine"};
  for (const double hurst : hurst_exponents) names.push_back(rmd_name(hurst));
  for (const Measured& surface : measured_surfaces) names.emplace_back(surface.name);
  return names;
}

bool is_random_scene(const std::string& name) {
  return name == "self-affine" || std::any_of(std::begin(hurst_exponents), std::end(hurst_exponents),
                                              [&](double hurst) { return name == rmd_name(hurst); });
}

FoundScene make_pareto_scene(const std::string& name, std::int64_t n, const std::string& folder, std::uint64_t seed) {
  FoundScene found;
  const auto found_is = [&](ParetoScene scene) {
    if (scene.n == 0) scene.n = n;
    scene.name = name;
    found.scene = std::move(scene);
    return found;
  };
  if (name == "hertz") return found_is(hertz());
  if (name == "wave") return found_is(wave());
  if (name == "waves") return found_is(waves());
  if (name == "punch") return found_is(punch());
  if (name == "self-affine") return found_is(self_affine(n, seed));
  for (const double hurst : hurst_exponents)
    if (name == rmd_name(hurst)) return found_is(midpoint(n, hurst, seed));
  for (const Measured& surface : measured_surfaces) {
    if (name != surface.name) continue;
    const std::string file = folder + "/" + surface.file;
    if (!folder.empty() && std::filesystem::exists(file)) return found_is(measured(file));
    found.missing = folder.empty() ? "no folder of measured surfaces is given (--surfaces)" : file + " is not there";
    return found;
  }
  throw Failure("unknown scene \"" + name + "\"");
}

}  // namespace bench
