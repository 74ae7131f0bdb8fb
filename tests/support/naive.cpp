#include "support/naive.h"

#include <gsl/gsl_sf_ellint.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace pairs {

namespace {

constexpr double pi = std::numbers::pi;

double x_asinh(double x, double y) { return x == 0 ? 0 : x * std::asinh(y / std::abs(x)); }
// Second mixed derivative 1/r.
double love_potential(double x, double y) { return x_asinh(x, y) + x_asinh(y, x); }
// Fourth mixed derivative 1/r.
double galerkin_potential(double x, double y) {
  return 0.5 * (x * y * x_asinh(x, y) + x * y * x_asinh(y, x)) - std::pow(std::hypot(x, y), 3) / 6;
}

double love(double x, double y, double hx, double hy) {
  double value = 0;
  for (const int a : {-1, 1})
    for (const int b : {-1, 1}) value += a * b * love_potential(x + 0.5 * a * hx, y + 0.5 * b * hy);
  return value / pi;
}

double galerkin(double x, double y, double hx, double hy) {
  double value = 0;
  for (const int a : {-1, 0, 1})
    for (const int b : {-1, 0, 1})
      value += (a == 0 ? -2 : 1) * (b == 0 ? -2 : 1) * galerkin_potential(std::abs(x + a * hx), std::abs(y + b * hy));
  return value / (pi * hx * hy);
}

// Johnson, Contact Mechanics (1985), eq. (3.42a), uniform pressure on a disc of the cell's width and load.
double disc(double r, double h) {
  const double a = 0.5 * h, k = a / r;
  return 4 * h * h / (pi * a * a) * r / pi *
         (gsl_sf_ellint_Ecomp(k, GSL_PREC_DOUBLE) - (1 - k * k) * gsl_sf_ellint_Kcomp(k, GSL_PREC_DOUBLE));
}

double periodic_coefficient(const rc_system& s, std::int64_t ix, std::int64_t iy) {
  double value = 0;
  for (std::int64_t ky = 0; ky < s.ny; ++ky)
    for (std::int64_t kx = 0; kx < s.nx; ++kx) {
      if (kx == 0 && ky == 0) continue;
      const double qx = 2 * pi * static_cast<double>(std::min(kx, s.nx - kx)) / (static_cast<double>(s.nx) * s.hx);
      const double qy = 2 * pi * static_cast<double>(std::min(ky, s.ny - ky)) / (static_cast<double>(s.ny) * s.hy);
      const double phase =
          2 * pi *
          (static_cast<double>(kx * ix) / static_cast<double>(s.nx) + static_cast<double>(ky * iy) / static_cast<double>(s.ny));
      value += 2 / std::hypot(qx, qy) * std::cos(phase);
    }
  return value / static_cast<double>(s.nx * s.ny);
}

// M images on either side one by one, those beyond by their integral, to the second order in 1/M. The datum is that of
// rc_result.approach.
double semi_periodic_coefficient(const rc_system& s, std::int64_t ix, std::int64_t iy) {
  const bool along_x = s.boundary == RC_BOUNDARY_PERIODIC_X;
  const double lx = static_cast<double>(s.nx) * s.hx, ly = static_cast<double>(s.ny) * s.hy, L = along_x ? lx : ly;
  const double x = static_cast<double>(ix) * s.hx, y = static_cast<double>(iy) * s.hy;
  const double along = along_x ? x : y, across = along_x ? y : x, h = along_x ? s.hx : s.hy, w = along_x ? s.hy : s.hx;
  const double M = std::ceil(400 * std::max(1.0, (along_x ? ly : lx) / L));
  double sum = 0;
  for (double m = M; m > 0; --m)
    for (const double place : {along + m * L, along - m * L}) sum += love(place, across, h, w);
  double beyond = 2 / L * std::log(lx + ly);
  for (const double from : {(M + 0.5) * L + along, (M + 0.5) * L - along}) {
    const double r = std::hypot(from, across);
    beyond -= std::log(from + r) / L + L * from / (24 * r * r * r);
    beyond += (2 * h * h - w * w) / (48 * L * from * from);
  }
  return sum + love(along, across, h, w) + h * w / pi * beyond;
}

// Coefficients are the same for all pairs of a test.
const Field& semi_periodic_table(const rc_system& s) {
  static std::map<std::tuple<std::int32_t, std::int64_t, std::int64_t, double, double>, Field> made;
  Field& table = made[{s.boundary, s.nx, s.ny, s.hx, s.hy}];
  if (table.empty())
    for (std::int64_t iy = 0; iy < s.ny; ++iy)
      for (std::int64_t ix = 0; ix < s.nx; ++ix) table.push_back(semi_periodic_coefficient(s, ix, iy));
  return table;
}

double over(double violation, double scale) { return violation == 0 ? 0 : violation / scale; }

}  // namespace

double coefficient(const std::string& kernel, double x, double y, double hx, double hy) {
  if (kernel == "love" || kernel == "auto") return love(x, y, hx, hy);
  if (kernel == "galerkin") return galerkin(x, y, hx, hy);
  const double r = std::hypot(x, y);
  if (kernel == "disc") return r == 0 ? 4 * hx / pi : disc(r, hx);
  if (kernel == "punch" || kernel == "eq9") {
    if (r == 0) return kernel == "eq9" ? 2 * hx / pi : hx;
    return 2 * hx / pi * std::asin(0.5 * hx / r);
  }
  throw Failure("no formula for kernel " + kernel);
}

Field influence_matrix(const Problem& problem) {
  const rc_system& s = problem.system;
  const auto n = s.nx * s.ny;
  Field table(static_cast<std::size_t>(n)), matrix(static_cast<std::size_t>(n * n));
  for (std::int64_t iy = 0; iy < s.ny; ++iy)
    for (std::int64_t ix = 0; ix < s.nx; ++ix)
      table[static_cast<std::size_t>(iy * s.nx + ix)] =
          (problem.periodic() ? periodic_coefficient(s, ix, iy)
           : problem.semi_periodic()
               ? semi_periodic_table(s)[static_cast<std::size_t>(iy * s.nx + ix)]
               : coefficient(problem.kernel, static_cast<double>(ix) * s.hx, static_cast<double>(iy) * s.hy, s.hx, s.hy)) /
          s.modulus;
  for (std::int64_t i = 0; i < n; ++i)
    for (std::int64_t j = 0; j < n; ++j)
      matrix[static_cast<std::size_t>(i * n + j)] =
          table[static_cast<std::size_t>(std::abs(i / s.nx - j / s.nx) * s.nx + std::abs(i % s.nx - j % s.nx))];
  return matrix;
}

Field product(const Field& matrix, const Field& x) {
  const std::size_t n = x.size();
  Field y(n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) y[i] += matrix[i * n + j] * x[j];
  return y;
}

Certificate certificate(const Problem& problem, const Field& matrix, const Field& p, double approach) {
  Certificate c{0, 0, 0, 0, 0, 0, 0, product(matrix, p)};
  const double largest_p = largest(p), hardness = problem.system.hardness > 0 ? problem.system.hardness : HUGE_VAL,
               scale = std::max(0.0, approach - problem.lowest_gap());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double hp = c.gap[i];
    c.gap[i] += problem.gap[i] - approach;
    if (!problem.included(i)) continue;
    c.load += p[i] * problem.cell_area();
    c.energy += (0.5 * hp - (approach - problem.gap[i])) * p[i] * problem.cell_area();
    c.contacts += p[i] > 0;
    c.primal = std::max({c.primal, over(-std::min(0.0, p[i]), largest_p), (p[i] - hardness) / hardness});
    const double room = c.gap[i] < 0 && hardness < HUGE_VAL ? std::max(0.0, (hardness - p[i]) / hardness) : HUGE_VAL;
    c.dual = std::max(c.dual, std::min(room, over(-std::min(0.0, c.gap[i]), scale)));
    c.complementarity = std::max(c.complementarity, std::min({over(p[i], largest_p), room, over(std::abs(c.gap[i]), scale)}));
  }
  if (problem.control == RC_CONTROL_LOAD) c.control = over(std::abs(c.load - problem.target), problem.target);
  return c;
}

void check_against_naive(const Problem& problem, const Answer& answer) {
  constexpr double round_off = 1e-12;
  const Certificate expected = certificate(problem, influence_matrix(problem), answer.p, answer.result.approach);
  const rc_result& r = answer.result;
  check_near(r.kkt_primal, expected.primal, round_off, "kkt_primal");
  check_near(r.kkt_dual, expected.dual, round_off, "kkt_dual");
  check_near(r.kkt_complementarity, expected.complementarity, round_off, "kkt_complementarity");
  check_near(r.kkt_control, expected.control, round_off, "kkt_control");
  check_near(r.load, expected.load, round_off * largest(answer.p) * static_cast<double>(answer.p.size()) * problem.cell_area(),
             "load");
  check_near(r.energy, expected.energy, round_off * std::abs(expected.energy), "energy");
  check_equal(r.contacts, expected.contacts, "contacts");
  check_near(r.area_fraction, static_cast<double>(expected.contacts) / static_cast<double>(answer.p.size()), 0, "area_fraction");
  double max_pressure = 0, sum_of_gaps = 0, included = 0;
  for (std::size_t i = 0; i < answer.p.size(); ++i) {
    if (!problem.included(i)) continue;
    const bool yields = problem.system.hardness > 0 && answer.p[i] >= problem.system.hardness;
    max_pressure = std::max(max_pressure, answer.p[i]);
    sum_of_gaps += yields ? std::max(expected.gap[i], 0.0) : expected.gap[i];
    ++included;
  }
  check_near(r.max_pressure, max_pressure, 0, "max_pressure");
  check_near(r.mean_gap, sum_of_gaps / included, 10 * round_off * largest(expected.gap), "mean_gap");
  for (std::size_t i = 0; i < answer.p.size(); ++i)
    if (problem.included(i)) check_near(answer.gap[i], expected.gap[i], 10 * round_off * largest(expected.gap), "gap");
}

}  // namespace pairs
