#include "patches.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <random>

namespace laws {

namespace {

using pairs::Field;

// Waves of amplitudes q^-(1 + hurst) with random phases, from `lowest` to a quarter of the grid, scaled to rms slope 0.1; as a
// gap.
Field self_affine(std::int64_t nx, std::int64_t ny, double hurst, int lowest, unsigned seed) {
  std::mt19937 generator(seed);
  const auto uniform = [&] { return static_cast<double>(generator()) / 4294967296.0; };
  const int highest = static_cast<int>(std::min(nx, ny) / 4);
  Field heights(static_cast<std::size_t>(nx * ny), 0.0);
  double square = 0;
  for (int ky = 0; ky <= highest; ++ky)
    for (int kx = ky == 0 ? 1 : -highest; kx <= highest; ++kx) {
      const double radius = std::hypot(kx, ky), phase = 2 * std::numbers::pi * uniform();
      if (radius < lowest || radius > highest) continue;
      const double qx = 2 * std::numbers::pi * kx / static_cast<double>(nx),
                   qy = 2 * std::numbers::pi * ky / static_cast<double>(ny);
      const double amplitude = std::pow(radius, -1 - hurst);
      square += amplitude * amplitude * (qx * qx + qy * qy) / 2;
      std::size_t i = 0;
      for (std::int64_t iy = 0; iy < ny; ++iy)
        for (std::int64_t ix = 0; ix < nx; ++ix)
          heights[i++] += amplitude * std::cos(qx * static_cast<double>(ix) + qy * static_cast<double>(iy) + phase);
    }
  const double top = *std::max_element(heights.begin(), heights.end()), scale = 0.1 / std::sqrt(square);
  for (double& height : heights) height = (top - height) * scale;
  return heights;
}

Patch patch(std::string name, std::int32_t boundary, const char* kernel, std::int64_t nx, std::int64_t ny, Field gap) {
  Patch made;
  made.name = std::move(name);
  made.problem.system.boundary = boundary;
  made.problem.system.nx = nx;
  made.problem.system.ny = ny;
  made.problem.kernel = kernel;
  made.problem.gap = std::move(gap);
  made.spec.p_lower = 2e-5;
  made.spec.p_upper = 1e-2;
  return made;
}

// The gap counts from the lowest point of the disc, as a law's does.
void mask_disc(Patch& patch) {
  const auto nx = patch.problem.system.nx, ny = patch.problem.system.ny;
  for (std::int64_t iy = 0; iy < ny; ++iy)
    for (std::int64_t ix = 0; ix < nx; ++ix)
      patch.problem.mask.push_back(std::hypot(static_cast<double>(2 * ix - nx), static_cast<double>(2 * iy - ny)) <
                                   0.9 * static_cast<double>(std::min(nx, ny)));
  double lowest = HUGE_VAL;
  for (std::size_t i = 0; i < patch.problem.gap.size(); ++i)
    if (patch.problem.included(i)) lowest = std::min(lowest, patch.problem.gap[i]);
  for (double& gap : patch.problem.gap) gap -= lowest;
}

}  // namespace

rc_law_spec Patch::asked() const {
  rc_law_spec whole = spec;
  whole.undeformed_gap = RC_IN(problem.gap.data());
  whole.mask = RC_IN(problem.mask.empty() ? nullptr : problem.mask.data());
  return whole;
}

Patch usual_patch(std::int64_t n) { return patch("usual", RC_BOUNDARY_PERIODIC, "auto", n, n, self_affine(n, n, 0.8, 4, 14)); }

Patch patch_named(const std::string& name) {
  constexpr std::int64_t n = 16;
  const bool disc = name == "disc", repeats = name == "hardness";
  Patch made = patch(name, repeats ? RC_BOUNDARY_PERIODIC : RC_BOUNDARY_FREE, repeats ? "spectral" : "love", n, n,
                     self_affine(n, n, 0.8, disc ? 2 : 4,
                                 disc      ? 9
                                 : repeats ? 18
                                           : 5));
  if (disc)
    mask_disc(made);
  else
    made.problem.system.hardness = 0.03;
  return made;
}

MadeLaw make(const Patch& patch) {
  const rc_law_spec spec = patch.asked();
  const auto options = pairs::make_options(pairs::automatic, patch.problem.kernel);
  MadeLaw result;
  rc_law* law = nullptr;
  result.status = rc_law_create(&patch.problem.system, options.get(), &spec, &law);
  result.message = rc_last_error();
  result.law.reset(law);
  return result;
}

LawHandle made(const Patch& patch) {
  MadeLaw result = make(patch);
  pairs::check(result.status >= 0, patch.name + ": " + result.message);
  return std::move(result.law);
}

rc_law_info describe(const rc_law* law) {
  rc_law_info info = RC_LAW_INFO_INIT;
  pairs::check_equal(rc_law_describe(law, &info), RC_OK, "rc_law_describe");
  return info;
}

rc_law_point evaluate(const rc_law* law, double x) {
  rc_law_point point = RC_LAW_POINT_INIT;
  pairs::check(rc_law_evaluate(law, x, &point) >= 0, "rc_law_evaluate");
  return point;
}

std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

const rc_law* usual_law() {
  static const LawHandle law = made(usual_patch(32));
  return law.get();
}

void refuses(rc_status status, const std::string& part, const std::string& what) {
  pairs::check_equal(status, RC_ERR_ARGUMENT, what);
  pairs::check(std::string(rc_last_error()).find(part) != std::string::npos, what + ": " + rc_last_error());
}

std::vector<double> overclosures(const rc_law* law) {
  const rc_law_info info = describe(law);
  std::vector<double> all{-1, 0, info.x_lower / 3, info.x_upper, 2 * info.x_upper};
  for (int i = 0; i <= 1000; ++i) all.push_back(info.x_lower * std::pow(info.x_upper / info.x_lower, i / 1000.0));
  return all;
}

}  // namespace laws
