// Conjugate gradients for A x = b, A symmetric and positive definite.
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace rc {

// How the iteration ended: by a failed product, whose status it has; along a direction whose curvature is not positive; or else
// with an answer that is good enough.
struct ConjugateGradientsEnd {
  int status = 0;
  double curvature = 1;  // t'At of the last direction t

  bool definite() const { return curvature > 0; }
};

// The unit for residuals that need none.
inline constexpr std::integral_constant<int, 1> no_unit;

// x: start in, answer out; r: its residual b - A x, updated with x. Residuals are divided by `unit`, the size of b, before they
// are squared, so that squares stay in range. sum(n, term) adds n terms. multiply(t, q) sets q = A t and returns 0 or a status.
// enough(step, rr) with the sum of squares rr is asked before every step and may look at x and r. turn(step, rr, q, t) makes t
// the next direction, where t and q = A t are the last, and returns (r / unit)'t; curvature is t'q. t, q: room for them, t of
// zeros.
template <class Unit, class Sum, class Multiply, class Enough, class Turn>
ConjugateGradientsEnd conjugate_gradients(std::span<double> x, std::span<double> r, const Unit& unit, std::vector<double>& t,
                                          std::vector<double>& q, const Sum& sum, const Multiply& multiply, const Enough& enough,
                                          const Turn& turn) {
  const std::size_t n = r.size();
  double curvature = 0;
  for (int step = 0;; ++step) {
    const double rr = sum(n, [&](std::size_t i) { return (r[i] / unit) * (r[i] / unit); });
    if (enough(step, rr)) return {};
    const double slope = turn(step, rr, curvature, q, t);
    if (const int status = multiply(t, q); status != 0) return {status};
    curvature = sum(n, [&](std::size_t i) { return t[i] * q[i]; });
    if (!(curvature > 0)) return {0, curvature};
    const double length = unit * (slope / curvature);
    for (std::size_t i = 0; i < n; ++i) {
      x[i] += length * t[i];
      r[i] -= length * q[i];
    }
  }
}

// Conjugate gradients without a preconditioner.
template <class Unit, class Sum, class Multiply, class Enough>
ConjugateGradientsEnd conjugate_gradients(std::span<double> x, std::span<double> r, const Unit& unit, const Sum& sum,
                                          const Multiply& multiply, const Enough& enough) {
  std::vector<double> first(r.size(), 0.0), second(r.size());
  double before = 0;
  return conjugate_gradients(x, r, unit, first, second, sum, multiply, enough,
                             [&](int step, double rr, double, const std::vector<double>&, std::vector<double>& t) {
                               const double beta = step == 0 ? 0 : rr / before;
                               for (std::size_t i = 0; i < t.size(); ++i) t[i] = r[i] / unit + beta * t[i];
                               return before = rr;
                             });
}

}  // namespace rc
