#include "contact/spectrum.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/limits.h"

namespace rc {

namespace {

double dot(const double* a, const double* b, std::size_t n) {
  double sum[4] = {0, 0, 0, 0};
  std::size_t i = 0;
  for (; i + 4 <= n; i += 4)
    for (std::size_t k = 0; k < 4; ++k) sum[k] += a[i + k] * b[i + k];
  for (; i < n; ++i) sum[0] += a[i] * b[i];
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

// L L' = H / scale - shift I, row by row.
class Cholesky {
 public:
  Cholesky(const rc_system& system, double scale, double shift)
      : n_(static_cast<std::size_t>(system.nx * system.ny)), l_(n_ * n_, 0.0) {
    for (std::size_t i = 0; i < n_ && positive_; ++i) {
      double* row = &l_[i * n_];
      const double* from = system.dense + static_cast<std::int64_t>(i) * system.dense_ld;
      for (std::size_t j = 0; j < i; ++j) row[j] = (from[j] / scale - dot(row, &l_[j * n_], j)) / l_[j * n_ + j];
      const double pivot = from[i] / scale - shift - dot(row, row, i);
      positive_ = pivot > 0;
      row[i] = std::sqrt(pivot);
    }
  }

  bool positive() const { return positive_; }

  void solve_lower(std::vector<double>& x) const {
    for (std::size_t i = 0; i < n_; ++i) x[i] = (x[i] - dot(&l_[i * n_], x.data(), i)) / l_[i * n_ + i];
  }
  void solve(std::vector<double>& x) const {
    solve_lower(x);
    for (std::size_t i = n_; i-- > 0;) {
      x[i] /= l_[i * n_ + i];
      for (std::size_t j = 0; j < i; ++j) x[j] -= l_[i * n_ + j] * x[i];
    }
  }

 private:
  std::size_t n_;
  std::vector<double> l_;
  bool positive_ = true;
};

// Estimates the lowest eigenvalue by inverse iteration, from above. A share of the estimate is a lower bound if H - shift I has a
// factorisation with that shift: it exists only if no eigenvalue is smaller (Sylvester's law of inertia).
Spectrum factorised(const System& system) {
  const auto n = static_cast<std::size_t>(system.points());
  const Cholesky factor(system.given, system.operator_scale, 0);
  if (!factor.positive()) return {};
  Spectrum result;
  result.diagonal = 1;

  std::vector<double> x(n, 1.0);
  factor.solve_lower(x);
  const double flat_punch = dot(x.data(), x.data(), n);

  double estimate = 0;
  for (std::size_t i = 0; i < n; ++i) x[i] = i % 2 == 0 ? 1 : -0.5;  // not an eigenvector of a symmetric arrangement
  for (int step = 0; step < 40; ++step) {
    const double before = std::sqrt(dot(x.data(), x.data(), n));
    for (double& value : x) value /= before;
    factor.solve(x);
    estimate = 1 / std::sqrt(dot(x.data(), x.data(), n));
  }
  // How far round-off and the allowed asymmetry can move an eigenvalue of a matrix with entries of at most 1.
  const double doubt = static_cast<double>(n) * (1e-12 + 2 * static_cast<double>(n) * epsilon);
  for (const double share : {0.9, 0.5, 0.1})
    if (Cholesky(system.given, system.operator_scale, share * estimate).positive()) {
      result.lowest = std::max(0.0, share * estimate - doubt);
      break;
    }
  // The factor is that of a matrix of at most H + doubt I, which is at most (1 + doubt / lowest) H: the inverse shrinks by no
  // more.
  if (result.lowest > 0) result.flat_punch = flat_punch * (1 + doubt / result.lowest);
  return result;
}

}  // namespace

Spectrum spectrum_of(const System& system) {
  if (system.given.op == RC_OPERATOR_DENSE && system.points() <= most_factorised_points) return factorised(system);
  if (!system.halfspace()) return {};
  Spectrum result;
  result.lowest = system.periodic() ? system.bounds.lambda_wave : system.bounds.lambda_min;
  result.galerkin_share = system.bounds.galerkin_share;
  system.kernel.influence->coefficients(system.unit, 1, 1, &result.diagonal);
  return result;
}

}  // namespace rc
