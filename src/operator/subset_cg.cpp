// H[a,a] x = b by conjugate gradients on the full product, for backends that cannot factor.
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "operator/operator.h"

namespace rc {

namespace {

constexpr double attained = 1e-15;    // relative residual at which a double precision product has nothing more to give
constexpr int patience = 40;          // iterations without a new smallest residual
constexpr double acceptable = 1e-11;  // above this, stopping early is a failure

}  // namespace

rc_status Operator::conjugate_gradients(std::span<const std::int64_t> a, const double* b, double* x, double tol) {
  const std::size_t m = a.size(), n = static_cast<std::size_t>(trial_.n);
  std::vector<double> spread(n, 0.0), product(n), r(b, b + m), t(m, 0.0), best(m, 0.0);
  const auto multiply = [&](const double* v) {
    for (std::size_t k = 0; k < m; ++k) spread[static_cast<std::size_t>(a[k])] = v[k];
    return apply(spread.data(), product.data());
  };

  double size_b = 0;
  for (std::size_t k = 0; k < m; ++k) size_b = std::max(size_b, std::abs(b[k]));
  const bool started = std::any_of(x, x + m, [](double value) { return value != 0; });
  if (size_b == 0) {
    std::fill(x, x + m, 0.0);
    return RC_OK;
  }
  const auto size_r = [&] {
    double largest = 0;
    for (const double value : r) largest = std::max(largest, std::abs(value) / size_b);
    return largest;
  };
  if (started) {
    if (const rc_status status = multiply(x); status != RC_OK) return status;
    for (std::size_t k = 0; k < m; ++k) r[k] = b[k] - product[static_cast<std::size_t>(a[k])];
    if (!(size_r() < 1)) {  // no better than nothing
      std::fill(x, x + m, 0.0);
      std::copy(b, b + m, r.begin());
    }
  }

  const double enough = std::max(tol, attained);
  double rr = 0, least = size_r();
  std::copy(x, x + m, best.begin());
  for (std::size_t k = 0; k < m; ++k) rr += (r[k] / size_b) * (r[k] / size_b);
  double rr_old = rr;
  for (std::size_t iteration = 0, since_best = 0; least > enough && since_best < patience; ++iteration) {
    for (std::size_t k = 0; k < m; ++k) t[k] = r[k] / size_b + (iteration == 0 ? 0 : rr / rr_old) * t[k];
    if (const rc_status status = multiply(t.data()); status != RC_OK) return status;
    double curvature = 0;
    for (std::size_t k = 0; k < m; ++k) curvature += t[k] * product[static_cast<std::size_t>(a[k])];
    if (!(curvature > 0)) {
      if (least <= acceptable) break;
      set_message(join("the operator is not positive definite: t'Ht = ", curvature, " on a set of ", m, " points").c_str());
      return RC_ERR_NUMERIC;
    }
    const double step = rr / curvature;
    double largest = 0;
    rr_old = rr;
    rr = 0;
    for (std::size_t k = 0; k < m; ++k) {
      x[k] += size_b * step * t[k];
      r[k] -= size_b * step * product[static_cast<std::size_t>(a[k])];
      largest = std::max(largest, std::abs(r[k]) / size_b);
      rr += (r[k] / size_b) * (r[k] / size_b);
    }
    ++since_best;
    if (largest < least) {
      if (largest < 0.9 * least) since_best = 0;
      least = largest;
      std::copy(x, x + m, best.begin());
    }
    if (rr == 0) break;
  }
  std::copy(best.begin(), best.end(), x);
  if (least > std::max(acceptable, tol)) {
    set_message(join("conjugate gradients on ", m, " points stopped at a relative residual of ", least).c_str());
    return RC_STOP_STALLED;
  }
  return RC_OK;
}

}  // namespace rc
