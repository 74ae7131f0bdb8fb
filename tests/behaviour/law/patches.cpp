#include "patches.h"

#include <roughcontact/derivatives.h>

#include <algorithm>
#include <cmath>
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

Field one_wave(std::int64_t nx, std::int64_t ny) {
  Field gap;
  for (std::int64_t iy = 0; iy < ny; ++iy)
    for (std::int64_t ix = 0; ix < nx; ++ix)
      gap.push_back(0.1 * static_cast<double>(nx) / (2 * std::numbers::pi) *
                    (1 - std::cos(2 * std::numbers::pi * static_cast<double>(ix) / static_cast<double>(nx)) *
                             std::cos(2 * std::numbers::pi * static_cast<double>(iy) / static_cast<double>(ny))));
  return gap;
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

std::vector<Patch> patches(std::int64_t n) {
  constexpr auto open = RC_BOUNDARY_FREE, periodic = RC_BOUNDARY_PERIODIC;
  std::vector<Patch> all;
  const auto add = [&](const char* name, std::int32_t boundary, const char* kernel, std::int64_t nx, std::int64_t ny,
                       Field gap) -> Patch& { return all.emplace_back(patch(name, boundary, kernel, nx, ny, std::move(gap))); };
  add("free, love", open, "love", n, n, self_affine(n, n, 0.8, 1, 1));
  add("free, love, hurst 0.3", open, "love", n, n, self_affine(n, n, 0.3, 1, 2));
  add("free, eq9", open, "eq9", n, n, self_affine(n, n, 0.8, 1, 3));
  add("free, galerkin", open, "galerkin", n, n, self_affine(n, n, 0.8, 1, 4));
  add("free, love, hardness, mean gap", open, "love", n, n, self_affine(n, n, 0.8, 4, 5)).problem.system.hardness = 0.03;
  add("free, love, one wave", open, "love", n, n, one_wave(n, n));
  add("free, love, as it is", open, "love", n, n, self_affine(n, n, 0.8, 2, 6)).spec.bulk = RC_LAW_BULK_NONE;
  Patch& given = add("free, love, bulk given", open, "love", n, n, self_affine(n, n, 0.8, 2, 7));
  given.spec.bulk = RC_LAW_BULK_GIVEN;
  given.spec.bulk_stiffness = static_cast<double>(n) / 0.86783;
  add("free, love, 2 to 1", open, "love", 2 * n, n, self_affine(2 * n, n, 0.8, 2, 8));
  mask_disc(add("free, love, disc", open, "love", n, n, self_affine(n, n, 0.8, 2, 9)));
  add("periodic, spectral", periodic, "spectral", n, n, self_affine(n, n, 0.8, 1, 10));
  add("periodic, spectral, hurst 0.3", periodic, "spectral", n, n, self_affine(n, n, 0.3, 1, 11));
  add("periodic, spectral, roll-off", periodic, "spectral", n, n, self_affine(n, n, 0.8, 4, 12));
  add("periodic, spectral, one wave", periodic, "spectral", n, n, one_wave(n, n));
  add("periodic, 2 to 1", periodic, "auto", 2 * n, n, self_affine(2 * n, n, 0.8, 2, 13));
  mask_disc(add("periodic, spectral, disc", periodic, "spectral", n, n, self_affine(n, n, 0.8, 2, 14)));
  Patch& full = add("periodic, spectral, nearly full", periodic, "spectral", n, n, self_affine(n, n, 0.8, 2, 15));
  full.spec.p_lower = 2e-4;
  full.spec.p_upper = 0.1;
  Patch& conductive = add("periodic, spectral, conductance", periodic, "spectral", n, n, self_affine(n, n, 0.8, 4, 16));
  conductive.spec.tolerance_conductance = 0.02;
  Patch& hard = add("free, love, hardness", open, "love", n, n, self_affine(n, n, 0.8, 2, 17));
  hard.problem.system.hardness = 0.03;
  hard.spec.bulk = RC_LAW_BULK_NONE;
  add("periodic, spectral, hardness", periodic, "spectral", n, n, self_affine(n, n, 0.8, 4, 18)).problem.system.hardness = 0.03;
  return all;
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

Referee::Referee(const Patch& patch, const rc_law_info& info)
    : patch_(patch),
      info_(info),
      contact_(patch.problem, pairs::automatic, {{"tol", "1e-11"}, {"stiffness", "1"}}),
      gap_(patch.problem.points()),
      weights_(patch.problem.points()) {}

double Referee::mean_rate(const rc_result& result) {
  std::size_t counted = 0;
  for (std::size_t i = 0; i < weights_.size(); ++i) counted += patch_.problem.included(i);
  std::vector<std::int64_t> points(weights_.size());
  Field p(weights_.size());
  std::int64_t n = 0;
  pairs::check_equal(
      rc_contact_points(contact_.handle(), static_cast<std::int64_t>(p.size()), RC_OUT(points.data()), RC_OUT(p.data()), &n),
      RC_OK, "points");
  weights_.assign(weights_.size(), 1 / static_cast<double>(counted));
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i)
    if (result.capped > 0 && p[i] >= patch_.problem.system.hardness) weights_[static_cast<std::size_t>(points[i])] = 0;
  rc_gradient gradient = RC_GRADIENT_INIT;
  gradient.dJ_dgap = RC_IN(weights_.data());
  pairs::check(rc_contact_gradient(contact_.handle(), &gradient) >= 0, rc_last_error());
  return -gradient.dJ_dtarget;
}

Truth Referee::at(double p) {
  pairs::check_equal(rc_contact_reset(contact_.handle()), RC_OK, "reset");
  pairs::Problem problem = patch_.problem;
  problem.control = RC_CONTROL_LOAD;
  problem.target = p * info_.area;
  rc_step step = problem.step();
  step.warm_start = 0;
  rc_result result = RC_RESULT_INIT;
  result.gap.data = gap_.data();
  pairs::check_equal(rc_contact_solve(contact_.handle(), &step, &result), RC_OK, std::string("solve ") + rc_last_error());
  Truth truth{result.approach, result.load / info_.area, result.stiffness / info_.area, -result.energy / info_.area,
              result.contact_area / info_.area};
  if (info_.bulk == RC_LAW_BULK_GIVEN) {
    truth.x -= result.load / info_.bulk_stiffness;
    truth.slope /= 1 - result.stiffness / info_.bulk_stiffness;
    truth.energy -= truth.p * result.load / (2 * info_.bulk_stiffness);
  }
  if (info_.bulk == RC_LAW_BULK_MEAN) {
    truth.x = info_.mean_gap - result.mean_gap;
    truth.slope = 1 / (mean_rate(result) * info_.area);
    truth.energy = std::nan("");
  }
  return truth;
}

}  // namespace laws
