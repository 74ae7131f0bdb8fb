#include "verification.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "support/naive.h"

namespace scenes {

namespace {

constexpr std::size_t most_for_sums = 400, most_for_dense = 1500;  // points
constexpr double round_off = 1e-12;                                // of two ways to multiply by H, relative
constexpr double epsilon = std::numeric_limits<double>::epsilon();

// The scale that residuals of gaps are relative to.
double scale_of(const pairs::Problem& problem, const pairs::Answer& answer, double tol) {
  const double lowest = problem.lowest_gap(), compression = std::max(0.0, answer.result.approach - lowest);
  if (!problem.periodic()) return compression;
  const double n = static_cast<double>(problem.points());
  if (problem.control == RC_CONTROL_LOAD)
    return std::max(compression, 0.25 * problem.target / n / std::sqrt(problem.cell_area()) / problem.system.modulus);
  double mean = 0;
  for (std::size_t i = 0; i < problem.gap.size(); ++i) {
    if (!problem.included(i)) return compression;
    mean += (problem.gap[i] - lowest) / n;
  }
  return std::min(compression, (mean - compression) / (2 * tol));
}

// The coefficients that a backend would store; those of periodic boundaries by a plain sum over the waves.
Field matrix_of(const pairs::Problem& problem) {
  if (problem.periodic()) return pairs::influence_matrix(problem);
  const rc_system& s = problem.system;
  const std::size_t n = problem.points();
  Field table(n), matrix(n * n);
  const std::string kernel = problem.kernel == "auto" ? "love" : problem.kernel;
  pairs::check(rc_kernel_coefficients(kernel.c_str(), s.hx, s.hy, s.nx, s.ny, table.data()) == RC_OK, rc_last_error());
  const auto nx = static_cast<std::int64_t>(s.nx), points = static_cast<std::int64_t>(n);
  for (std::int64_t i = 0; i < points; ++i)
    for (std::int64_t j = 0; j < points; ++j)
      matrix[static_cast<std::size_t>(i * points + j)] =
          table[static_cast<std::size_t>(std::abs(i / nx - j / nx) * nx + std::abs(i % nx - j % nx))] / s.modulus;
  return matrix;
}

}  // namespace

Verification::Verification(const Scene& scene)
    : tol_(scene.tol), settings_{{RC_OPT_TOL, pairs::text(scene.tol)}, {RC_OPT_BOUNDS, "0"}} {
  const std::size_t n = scene.problem.points();
  if (n <= most_for_sums)
    matrix_ = matrix_of(scene.problem);
  else
    other_.emplace(scene.problem, pairs::Pair{"auto", n <= most_for_dense ? "dense" : "fft"}, settings_);
}

// H p + h - d
Field Verification::gap_of(const pairs::Problem& problem, const pairs::Answer& answer) {
  if (matrix_) {
    Field gap = pairs::product(*matrix_, answer.p);
    for (std::size_t i = 0; i < gap.size(); ++i) gap[i] += problem.gap[i] - answer.result.approach;
    return gap;
  }
  pairs::Problem given = problem;
  given.control = RC_CONTROL_APPROACH;
  given.target = answer.result.approach;
  // Full periodic contact has no approach that could be prescribed: the gap is the same up to a constant.
  const rc_step step = given.step();
  pairs::Answer second = other_->certify(step, answer.p);
  if (second.status == RC_ERR_INFEASIBLE) {
    second = other_->certify(problem.step(), answer.p);
    for (double& value : second.gap) value += second.result.approach - answer.result.approach;
  }
  pairs::check(second.status >= 0, "certifying again: " + second.message);
  return second.gap;
}

void Verification::check(const pairs::Problem& problem, const pairs::Answer& answer) {
  using pairs::check, pairs::text;
  const rc_result& r = answer.result;
  const Field gap = gap_of(problem, answer);
  double load = 0;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    check(answer.p[i] >= 0, "negative pressure");
    check(problem.included(i) || answer.p[i] == 0, "pressure under the mask");
    load += answer.p[i] * problem.cell_area();
  }
  const rc_system& s = problem.system;
  const double largest_p = pairs::largest(answer.p), scale = scale_of(problem, answer, tol_);
  // A product is a sum of terms that may be large beside it, as those of the longest wave.
  const double longest = std::max(s.hx * static_cast<double>(s.nx), s.hy * static_cast<double>(s.ny)) / s.modulus;
  const double of_product = round_off * largest_p * longest;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    if (!problem.included(i)) continue;
    const double noise = of_product + 8 * epsilon * (std::abs(problem.gap[i]) + std::abs(r.approach));
    const double apart = std::abs(gap[i] - answer.gap[i]), allowed = tol_ * (1 + 1e-6) * scale + noise;
    const std::string point = " at point " + std::to_string(i);
    check(apart <= noise, "the gap is off by " + text(apart) + " where round-off is " + text(noise) + point);
    check(gap[i] >= -allowed, "overlap " + text(-gap[i]) + " with scale " + text(scale) + point);
    check(answer.p[i] <= tol_ * largest_p || gap[i] <= allowed, "pressure across a gap of " + text(gap[i]) + point);
  }
  pairs::check_near(r.load, load, 1e-12 * load, "load");
  if (problem.control == RC_CONTROL_LOAD)
    pairs::check_near(load, problem.target, (tol_ + 1e-12) * problem.target, "load against its target");
  if (problem.control == RC_CONTROL_APPROACH)
    pairs::check(r.approach == problem.target, "the approach is not the prescribed one");
}

}  // namespace scenes
