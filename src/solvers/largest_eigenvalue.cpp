#include "solvers/largest_eigenvalue.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/sums.h"

namespace rc {

namespace {

constexpr int collatz_steps = 4, power_steps = 8;
constexpr double power_margin = 1.15;  // power iteration approaches the eigenvalue from below

// Collatz (1942): for H without negative entries and any x > 0, max_i (Hx)_i / x_i >= lambda_max; it tightens as x nears the
// Perron vector.
double collatz_bound(const Problem& problem) {
  Vector x(static_cast<std::size_t>(problem.size()), 1.0), y(x.size());
  double bound = std::numeric_limits<double>::infinity();
  for (int k = 0; k < collatz_steps; ++k) {
    problem.apply(x, y);
    double largest_ratio = 0;
    for (std::size_t i = 0; i < x.size(); ++i) largest_ratio = std::max(largest_ratio, y[i] / x[i]);
    bound = std::min(bound, largest_ratio);
    const double scale = *std::max_element(y.begin(), y.end());
    if (!(*std::min_element(y.begin(), y.end()) > 0) || !(scale > 0)) break;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = y[i] / scale;
  }
  return bound;
}

// The largest |A x| / |x| of a few power steps, from a vector of all frequencies. multiply(x, y) sets y = A x.
template <class Multiply> double power_estimate(std::size_t n, const Multiply& multiply) {
  Vector x(n), y(n);
  std::uint32_t noise = 1;
  for (double& value : x) value = 1 + (noise = noise * 1664525u + 1013904223u) * 0x1p-32;
  double largest = 0;
  for (int k = 0; k < power_steps; ++k) {
    const double norm = std::sqrt(sum_of(n, [&](std::size_t i) { return x[i] * x[i]; }));
    if (!(norm > 0)) break;
    for (double& value : x) value /= norm;
    multiply(x, y);
    largest = std::max(largest, std::sqrt(sum_of(n, [&](std::size_t i) { return y[i] * y[i]; })));
    x.swap(y);
  }
  return largest;
}

}  // namespace

double largest_eigenvalue(const Problem& problem) {
  if (problem.positive()) return collatz_bound(problem);
  return power_margin *
         power_estimate(static_cast<std::size_t>(problem.size()), [&](const Vector& x, Vector& y) { problem.apply(x, y); });
}

double smallest_eigenvalue(const Problem& problem, double largest) {
  const double complement = power_estimate(static_cast<std::size_t>(problem.size()), [&](const Vector& x, Vector& y) {
    problem.apply(x, y);
    for (std::size_t i = 0; i < x.size(); ++i) y[i] = largest * x[i] - y[i];
  });
  return std::max(0.0, largest - complement);
}

}  // namespace rc
