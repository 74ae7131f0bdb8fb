#include "solvers/gradient_projection.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "solvers/vector_math.h"

namespace rc {

namespace {

constexpr int power_steps = 8;
constexpr double margin = 1.15;  // power iteration comes from below

// An estimate of lambda_max that needs neither positive entries nor a null space without constants: power iteration from a vector
// of all frequencies. Where it is still too small, the restart keeps the iteration from running away.
double largest_eigenvalue(const Problem& problem, std::size_t n) {
  Vector x(n), y(n);
  std::uint32_t noise = 1;
  for (double& value : x) value = 1 + (noise = noise * 1664525u + 1013904223u) * 0x1p-32;
  double largest = 0;
  for (int k = 0; k < power_steps; ++k) {
    const double norm = std::sqrt(sum_of(n, [&](std::size_t i) { return x[i] * x[i]; }));
    if (!(norm > 0)) break;
    for (double& value : x) value /= norm;
    problem.apply(x, y);
    largest = std::max(largest, std::sqrt(sum_of(n, [&](std::size_t i) { return y[i] * y[i]; })));
    x.swap(y);
  }
  return largest;
}

}  // namespace

void gradient_projection(const Problem& problem, Vector& p, int steps) {
  const std::size_t n = p.size();
  const double eigenvalue = largest_eigenvalue(problem, n);
  if (!(eigenvalue > 0)) return;
  const double length = 1 / (margin * eigenvalue);
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
