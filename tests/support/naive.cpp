#include "support/naive.h"

#include <algorithm>
#include <cmath>

#include "scenes/influence.h"

namespace pairs {

namespace {

scenes::Reals coefficients(const rc_system& system, const std::string& kernel) {
  scenes::Scene scene;
  scene.system = system;
  scene.kernel = kernel;
  return scenes::influence_table(scene);
}

double over(double violation, double scale) { return violation == 0 ? 0 : violation / scale; }

}  // namespace

double coefficient(const std::string& kernel, std::int64_t ix, std::int64_t iy, double hx, double hy) {
  rc_system system = support::unit_system();
  system.nx = ix + 1;
  system.ny = iy + 1;
  system.hx = hx;
  system.hy = hy;
  return static_cast<double>(coefficients(system, kernel).back());
}

Field influence_matrix(const Problem& problem) {
  const rc_system& s = problem.system;
  const auto n = s.nx * s.ny;
  const scenes::Reals table = coefficients(s, problem.kernel);
  Field matrix(static_cast<std::size_t>(n * n));
  for (std::int64_t i = 0; i < n; ++i)
    for (std::int64_t j = 0; j < n; ++j)
      matrix[static_cast<std::size_t>(i * n + j)] = static_cast<double>(
          table[static_cast<std::size_t>(std::abs(i / s.nx - j / s.nx) * s.nx + std::abs(i % s.nx - j % s.nx))]);
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
