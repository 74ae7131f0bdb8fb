#include "conjugate_gradients.h"

#include "common/serial_eigen.h"

namespace rc_cholmod {

namespace {

constexpr double attained = 1e-15;  // least relative residual that products in double precision can reach
constexpr int patience = 40;        // iterations without a new smallest residual

}  // namespace

Conclusion conjugate_gradients(std::int64_t n, const std::function<void(const double* x, double* y)>& multiply,
                               const std::function<void(double* r)>& precondition, const double* b, double* x) {
  using Eigen::VectorXd;
  const Eigen::Map<const VectorXd> right(b, n);
  Eigen::Map<VectorXd> best(x, n);
  best.setZero();
  const double size = right.cwiseAbs().maxCoeff();
  if (size == 0.0) return {0, 0.0, 1.0};
  VectorXd r = right / size, current = VectorXd::Zero(n), z(n), t = VectorXd::Zero(n), product(n);
  Conclusion reached{0, 1.0, 1.0};
  double rz_old = 1.0;
  for (int since_best = 0; reached.residual > attained && since_best < patience; ++reached.iterations) {
    z = r;
    if (precondition) precondition(z.data());
    const double rz = r.dot(z);
    t = z + (reached.iterations == 0 ? 0.0 : rz / rz_old) * t;
    rz_old = rz;
    multiply(t.data(), product.data());
    reached.curvature = t.dot(product);
    if (!(reached.curvature > 0.0)) break;
    const double step = rz / reached.curvature;
    current += step * t;
    r -= step * product;
    const double largest = r.cwiseAbs().maxCoeff();
    ++since_best;
    if (largest < reached.residual) {
      if (largest < 0.9 * reached.residual) since_best = 0;
      reached.residual = largest;
      best = size * current;
    }
  }
  return reached;
}

}  // namespace rc_cholmod
