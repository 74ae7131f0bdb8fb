#include "contact/spectrum.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/cholesky.h"
#include "core/limits.h"

namespace rc {

namespace {

// L L' = H / scale - shift I.
Cholesky factor_of(const System& system, double shift) {
  const rc_system& given = system.given;
  return {static_cast<std::size_t>(system.points()), [&](std::size_t i, std::size_t j) {
            const double entry = given.dense[static_cast<std::int64_t>(i) * given.dense_ld + static_cast<std::int64_t>(j)];
            return i == j ? entry / system.operator_scale - shift : entry / system.operator_scale;
          }};
}

// Estimates the lowest eigenvalue by inverse iteration, from above. A share of the estimate is a lower bound if H - shift I has a
// factorisation with that shift: it exists only if no eigenvalue is smaller (Sylvester's law of inertia).
Spectrum factorised(const System& system) {
  const auto n = static_cast<std::size_t>(system.points());
  const Cholesky factor = factor_of(system, 0);
  if (!factor.positive()) return {};
  Spectrum result;
  result.diagonal = 1;

  std::vector<double> x(n, 1.0);
  factor.solve_lower(x);
  const double flat_punch = Cholesky::dot(x.data(), x.data(), n);

  double estimate = 0;
  for (std::size_t i = 0; i < n; ++i) x[i] = i % 2 == 0 ? 1 : -0.5;  // not an eigenvector of a symmetric arrangement
  for (int step = 0; step < 40; ++step) {
    const double before = std::sqrt(Cholesky::dot(x.data(), x.data(), n));
    for (double& value : x) value /= before;
    factor.solve(x);
    estimate = 1 / std::sqrt(Cholesky::dot(x.data(), x.data(), n));
  }
  // How far round-off and the allowed asymmetry can move an eigenvalue of a matrix with entries of at most 1.
  const double doubt = static_cast<double>(n) * (1e-12 + 2 * static_cast<double>(n) * epsilon);
  for (const double share : {0.9, 0.5, 0.1})
    if (factor_of(system, share * estimate).positive()) {
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
