// (H + rho I) x = b by conjugate gradients on the product, for backends that cannot factor. The shift bounds the condition
// number, so a few iterations from a good start are enough.
#include <vector>

#include "core/conjugate_gradients.h"
#include "core/error.h"
#include "core/stall.h"
#include "core/sums.h"
#include "operator/operator.h"

namespace rc {

rc_status Operator::shifted(double rho, double tol, const double* b, double* x) {
  constexpr double progress = 0.8;  // the residual's sum of squares falls where it is below this share of the mark
  constexpr int patience = 38;      // iterations without such a fall
  const auto n = static_cast<std::size_t>(trial_.n);
  if (backend_.shifted) {
    // H = B / scale, so B + (scale rho) I is solved for scale b.
    std::vector<double> right(b, b + n);
    for (double& value : right) value *= scale_;
    return seen(backend_.shifted(self_, rho * scale_, right.data(), x));
  }
  const auto multiply = [&](const double* v, std::vector<double>& q) {
    const rc_status status = apply(v, q.data());
    for (std::size_t i = 0; i < n; ++i) q[i] += rho * v[i];
    return status;
  };
  std::vector<double> r(n);
  if (const rc_status status = multiply(x, r); status != RC_OK) return status;
  for (std::size_t i = 0; i < n; ++i) r[i] = b[i] - r[i];
  const double least = tol * tol * sum_in_order(n, [&](std::size_t i) { return b[i] * b[i]; });
  Stall stalls = Stall::from(sum_in_order(n, [&](std::size_t i) { return r[i] * r[i]; }), progress, patience);
  const ConjugateGradientsEnd end = conjugate_gradients(
      {x, n}, r, no_unit, sum_in_order,
      [&](const std::vector<double>& t, std::vector<double>& q) { return multiply(t.data(), q); },
      [&](int step, double rr) { return !(rr > least) || (step > 0 && stalls(rr)); });
  if (end.status != 0) return end.status;
  if (!end.definite()) {
    set_message(join("the operator is not positive definite: t'(H + rho I)t = ", end.curvature, " with rho = ", rho).c_str());
    return RC_ERR_NUMERIC;
  }
  return RC_OK;
}

}  // namespace rc
