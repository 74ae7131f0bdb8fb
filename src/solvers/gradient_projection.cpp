#include "solvers/gradient_projection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solvers/vector_math.h"

namespace rc {

namespace {

constexpr int bound_steps = 4;
constexpr double margin = 1.01;

// Collatz: for H with positive entries and any x > 0, max_i (Hx)_i / x_i bounds lambda_max from above; it tightens as x nears the
// Perron vector. For other matrices it is an estimate, made safe by the restart.
double lipschitz_bound(const Problem& problem, std::size_t n) {
  Vector x(n, 1.0), y(n);
  double bound = 0;
  for (int k = 0; k < bound_steps; ++k) {
    problem.apply(x, y);
    bound = 0;
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      bound = std::max(bound, std::abs(y[i]) / x[i]);
      largest = std::max(largest, std::abs(y[i]));
    }
    for (std::size_t i = 0; i < n; ++i) x[i] = std::max(std::abs(y[i]) / largest, 1e-3);
  }
  return bound;
}

}  // namespace

void gradient_projection(const Problem& problem, Vector& p, int steps) {
  const std::size_t n = p.size();
  const double length = 1 / (margin * lipschitz_bound(problem, n));
  Vector s = p, previous = p, gradient(n);
  for (int k = 0, i = 0; k < steps; ++k, ++i) {
    const double beta = i < 2 ? 0 : (i - 1.0) / (i + 2.0);
    for (std::size_t j = 0; j < n; ++j) s[j] = p[j] + beta * (p[j] - previous[j]);
    problem.apply(s, gradient);
    previous.swap(p);
    for (std::size_t j = 0; j < n; ++j) p[j] = std::max(0.0, s[j] - length * (gradient[j] - problem.u()[j]));
    const double uphill = sum_of(n, [&](std::size_t j) { return (s[j] - p[j]) * (p[j] - previous[j]); });
    if (uphill > 0) i = -1;
  }
}

}  // namespace rc
