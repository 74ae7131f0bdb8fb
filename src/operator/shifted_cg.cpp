// (H + rho I) x = b by conjugate gradients on the product, for backends that cannot factor. The shift bounds the condition
// number, so a few iterations from a good start are enough.
#include <cmath>
#include <vector>

#include "core/error.h"
#include "operator/operator.h"

namespace rc {

namespace {

constexpr int patience = 40;  // iterations without a new smallest residual

}  // namespace

rc_status Operator::shifted(double rho, double tol, const double* b, double* x) {
  const auto n = static_cast<std::size_t>(trial_.n);
  if (backend_.shifted) {
    // H = B / scale, so B + (scale rho) I is solved for scale b.
    std::vector<double> right(b, b + n);
    for (double& value : right) value *= scale_;
    return backend_.shifted(self_, rho * scale_, right.data(), x);
  }
  std::vector<double> r(n), t(n), product(n);
  const auto multiply = [&](const double* v) {
    const rc_status status = apply(v, product.data());
    for (std::size_t i = 0; i < n; ++i) product[i] += rho * v[i];
    return status;
  };
  if (const rc_status status = multiply(x); status != RC_OK) return status;
  double size_b = 0, rr = 0;
  for (std::size_t i = 0; i < n; ++i) {
    r[i] = b[i] - product[i];
    t[i] = r[i];
    size_b += b[i] * b[i];
    rr += r[i] * r[i];
  }
  double least = rr;
  for (int since_best = 0; rr > tol * tol * size_b && since_best < patience; ++since_best) {
    if (const rc_status status = multiply(t.data()); status != RC_OK) return status;
    double curvature = 0;
    for (std::size_t i = 0; i < n; ++i) curvature += t[i] * product[i];
    if (!(curvature > 0)) {
      set_message(join("the operator is not positive definite: t'(H + rho I)t = ", curvature, " with rho = ", rho).c_str());
      return RC_ERR_NUMERIC;
    }
    const double step = rr / curvature, rr_old = rr;
    rr = 0;
    for (std::size_t i = 0; i < n; ++i) {
      x[i] += step * t[i];
      r[i] -= step * product[i];
      rr += r[i] * r[i];
    }
    for (std::size_t i = 0; i < n; ++i) t[i] = r[i] + rr / rr_old * t[i];
    if (rr < 0.8 * least) {
      least = rr;
      since_best = 0;
    }
  }
  return RC_OK;
}

}  // namespace rc
