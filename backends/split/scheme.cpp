#include "scheme.h"

#include <cmath>
#include <numbers>

namespace rc_split {

// The power series: its terms are positive, so nothing cancels.
double bessel_i0(double x) {
  const double quarter = 0.25 * x * x;
  double term = 1, sum = 1;
  for (int k = 1; term > 1e-17 * sum; ++k) {
    term *= quarter / (static_cast<double>(k) * k);
    sum += term;
  }
  return sum;
}

namespace {

// int_0^x I0(c sqrt(1 - t^2)) dt / x, by Gauss's rule with 4 points on each of 32 parts.
double mean_density(double c, double x) {
  constexpr double node[] = {0.069431844202973713, 0.33000947820757187}, weight[] = {0.17392742256872693, 0.32607257743127307};
  constexpr int parts = 32;
  double sum = 0;
  for (int i = 0; i < parts; ++i)
    for (int j = 0; j < 2; ++j)
      for (double s : {node[j], 1 - node[j]}) {
        const double t = x * (i + s) / parts;
        sum += weight[j] * bessel_i0(c * std::sqrt(1 - t * t));
      }
  return sum / parts;
}

}  // namespace

// Interpolation at Chebyshev's points.
Smoothed::Smoothed(double shape) {
  constexpr int points = degree + 1;
  const double whole = mean_density(shape, 1);
  for (int i = 0; i < points; ++i) {
    const double angle = std::numbers::pi * (i + 0.5) / points;
    const double value = mean_density(shape, std::sqrt(0.5 * (1 + std::cos(angle)))) / whole;
    for (int k = 0; k < points; ++k)
      c_[static_cast<std::size_t>(k)] += (k == 0 ? 1.0 : 2.0) / points * value * std::cos(k * angle);
  }
}

Window::Window(int nodes, double fraction)
    : q_(nodes), beta_(0.5 * nodes * (2 * std::numbers::pi - fraction)), i0_(bessel_i0(beta_)) {}

double Window::operator()(double t) const {
  const double x = 2 * t / q_;
  return x * x >= 1 ? 0 : bessel_i0(beta_ * std::sqrt(1 - x * x)) / i0_;
}

double Window::transform(double theta) const {
  const double square = beta_ * beta_ - 0.25 * q_ * q_ * theta * theta, z = std::sqrt(std::abs(square));
  const double ratio = z < 1e-8 ? 1 : (square > 0 ? std::sinh(z) : std::sin(z)) / z;
  return q_ / i0_ * ratio;
}

}  // namespace rc_split
