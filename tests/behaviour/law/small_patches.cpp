#include "small_patches.h"

#include <algorithm>
#include <cmath>

#include "support/naive.h"

namespace laws {

namespace {

using pairs::Field;

constexpr int open_point = 0, contact_point = 1, capped_point = 2;

double uniform(std::mt19937& generator) { return (static_cast<double>(generator()) + 0.5) / 4294967296.0; }
double between(std::mt19937& generator, double low, double high) { return low + (high - low) * uniform(generator); }
std::int64_t whole(std::mt19937& generator, int low, int high) {
  return low + static_cast<std::int64_t>(uniform(generator) * (high - low + 1));
}

// A few asperities of equal and other heights, or roughness that may have ties. The lowest point has the gap 0.
Field random_gap(std::mt19937& generator, std::size_t points) {
  Field gap(points, 3.0);
  if (uniform(generator) < 0.5) {
    for (std::int64_t k = whole(generator, 1, 5); k > 0; --k)
      gap[generator() % points] =
          uniform(generator) < 0.5 ? 0 : 0.25 * static_cast<double>(whole(generator, 1, 4)) * uniform(generator);
  } else {
    const bool ties = uniform(generator) < 0.4;
    for (double& value : gap) value = ties ? static_cast<double>(whole(generator, 0, 4)) / 4 : uniform(generator);
  }
  return gap;
}

// Positive definite: a matrix of love, one that falls with the distance, or a random one.
void own_matrix(std::mt19937& generator, SmallPatch& small) {
  pairs::Problem& problem = small.patch.problem;
  const std::size_t n = problem.points();
  const double kind = uniform(generator);
  problem.system.boundary = RC_BOUNDARY_FREE;
  problem.kernel = "love";
  small.matrix = pairs::influence_matrix(problem);
  if (kind > 0.3) {
    const double range = between(generator, 0.5, 3), smooth = between(generator, 1, 2);
    const auto nx = static_cast<std::size_t>(problem.system.nx);
    Field factor(n * n);
    for (double& entry : factor) entry = uniform(generator);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const double r = std::hypot(static_cast<double>(i % nx) - static_cast<double>(j % nx),
                                    static_cast<double>(i / nx) - static_cast<double>(j / nx));
        double& entry = small.matrix[i * n + j];
        entry = i == j ? 0.05 : 0;
        if (kind < 0.6) entry += std::exp(-std::pow(r / range, smooth));
        for (std::size_t k = 0; k < n && kind >= 0.6; ++k)
          entry += factor[i * n + k] * factor[j * n + k] / static_cast<double>(n);
      }
  }
  problem.system.boundary = 0;
  problem.system.modulus = 0;
  problem.system.op = RC_OPERATOR_DENSE;
  problem.system.dense_ld = static_cast<std::int64_t>(n);
  problem.kernel = "auto";
}

}  // namespace

SmallPatch small_patch(std::mt19937& generator, bool hard) {
  SmallPatch small;
  Patch& patch = small.patch;
  pairs::Problem& problem = patch.problem;
  rc_system& system = problem.system;
  const double kind = uniform(generator);
  system.nx = whole(generator, 2, 7);
  system.ny = uniform(generator) < 0.2 ? 1 : whole(generator, 2, 6);
  problem.kernel = "love";
  system.boundary = RC_BOUNDARY_FREE;
  if (kind < 0.2 && system.ny > 1) {
    system.boundary = RC_BOUNDARY_PERIODIC;
    problem.kernel = "auto";
  } else if (kind < 0.3) {
    system.nx = 5, system.ny = 4;  // the coefficients of one shape are computed once
    system.boundary = uniform(generator) < 0.5 ? RC_BOUNDARY_PERIODIC_X : RC_BOUNDARY_PERIODIC_Y;
    problem.kernel = "auto";
    small.slack = 1e-6;
  } else if (kind < 0.4) {
    problem.kernel = "galerkin";
  }
  if (kind > 0.85)
    own_matrix(generator, small);
  else
    small.matrix = pairs::influence_matrix(problem);
  problem.gap = random_gap(generator, problem.points());
  if (uniform(generator) < 0.2) {
    for (std::size_t i = 0; i < problem.points(); ++i) problem.mask.push_back(uniform(generator) < 0.8);
    problem.mask[generator() % problem.points()] = 1;
  }
  const double lowest = problem.lowest_gap();
  for (double& gap : problem.gap) gap -= lowest;
  patch.spec.p_upper = 0.02 * std::pow(10, between(generator, -1, 1));
  if (hard) {
    system.hardness = std::pow(10, between(generator, -1.5, 0.3));
    std::size_t included = 0;
    for (std::size_t i = 0; i < problem.points(); ++i) included += problem.included(i);
    const double most = system.hardness * static_cast<double>(included) / static_cast<double>(problem.points());
    patch.spec.p_upper = std::min(patch.spec.p_upper, 0.9 * most);
  }
  patch.spec.p_lower = patch.spec.p_upper * std::pow(10, -between(generator, 0.05, 2.5));
  patch.spec.tolerance = std::pow(10, -between(generator, 1, 3.5));
  const double bulk = uniform(generator);
  patch.spec.bulk = bulk < 0.15 ? RC_LAW_BULK_AUTO : RC_LAW_BULK_NONE;
  if (bulk > 0.85) {
    patch.spec.bulk = RC_LAW_BULK_GIVEN;
    patch.spec.bulk_stiffness = between(generator, 3, 10) * static_cast<double>(problem.points());
  }
  return small;
}

SmallPatch two_asperities(double step, double tolerance) {
  SmallPatch small;
  pairs::Problem& problem = small.patch.problem;
  problem.system.boundary = RC_BOUNDARY_FREE;
  problem.system.nx = 15, problem.system.ny = 1;
  problem.system.hardness = 1;
  problem.kernel = "love";
  problem.gap.assign(15, 10);
  problem.gap[3] = 0, problem.gap[11] = step;
  small.matrix = pairs::influence_matrix(problem);
  small.patch.spec.p_lower = 0.2 / 15, small.patch.spec.p_upper = 1.6 / 15;
  small.patch.spec.tolerance = tolerance;
  small.patch.spec.bulk = RC_LAW_BULK_NONE;
  return small;
}

// Points come to the state that their pressure and gap ask for, all at a time at first and then, lest states repeat, the first
// one.
Exact ExactLaw::at(double approach) {
  const pairs::Problem& problem = small_.patch.problem;
  const std::size_t n = problem.points();
  const double hardness = problem.system.hardness > 0 ? problem.system.hardness : HUGE_VAL;
  if (state_.empty()) state_.assign(n, open_point);
  Field p(n), gap(n);
  std::vector<std::size_t> free;
  Field factor;
  for (int round = 0;; ++round) {
    pairs::check(round < 2000, "no answer at " + pairs::text(approach));
    free.clear();
    for (std::size_t i = 0; i < n; ++i) {
      p[i] = state_[i] == capped_point ? hardness : 0;
      if (state_[i] == contact_point) free.push_back(i);
    }
    const std::size_t m = free.size();
    factor.assign(m * m, 0);
    Field right(m), rest = pairs::product(small_.matrix, p);
    for (std::size_t a = 0; a < m; ++a) {
      right[a] = approach - problem.gap[free[a]] - rest[free[a]];
      for (std::size_t b = 0; b < m; ++b) factor[a * m + b] = small_.matrix[free[a] * n + free[b]];
    }
    const Field found = m > 0 ? pairs::solve_linear(factor, right) : Field{};
    for (std::size_t a = 0; a < m; ++a) p[free[a]] = found[a];
    gap = pairs::product(small_.matrix, p);
    bool changed = false;
    for (std::size_t i = 0; i < n && !(changed && round > 30); ++i) {
      gap[i] += problem.gap[i] - approach;
      if (!problem.included(i)) continue;
      const double little = 1e-13;
      int wanted = state_[i];
      if (state_[i] == open_point && gap[i] < -little) wanted = contact_point;
      if (state_[i] == contact_point && p[i] < -little) wanted = open_point;
      if (state_[i] == contact_point && p[i] > hardness * (1 + little)) wanted = capped_point;
      if (state_[i] == capped_point && gap[i] > little) wanted = contact_point;
      changed = changed || wanted != state_[i];
      state_[i] = wanted;
    }
    if (!changed) break;
  }
  Exact exact{approach, 0, 0};
  double mean = 0, included = 0;
  for (std::size_t i = 0; i < n; ++i) {
    exact.p += p[i] * problem.cell_area() / info_.area;
    if (!problem.included(i)) continue;
    mean += std::max(0.0, gap[i]);
    ++included;
  }
  if (!free.empty())
    exact.slope = pairs::sum(pairs::solve_linear(factor, Field(free.size(), 1.0))) * problem.cell_area() / info_.area;
  if (info_.bulk == RC_LAW_BULK_GIVEN) exact.x -= exact.p * info_.area / info_.bulk_stiffness;
  if (info_.bulk == RC_LAW_BULK_MEAN) exact.x = info_.mean_gap - mean / included;
  return exact;
}

}  // namespace laws
