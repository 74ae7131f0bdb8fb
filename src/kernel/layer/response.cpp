#include "kernel/layer/response.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace rc::kernel::layer {

namespace {

// sinh x - x for small x
template <class Number> Number sinh_beyond(Number x) {
  const Number square = x * x;
  Number sum = 1;
  for (int n = 17; n > 3; n -= 2) sum = 1.0 + sum * square / static_cast<double>(n * (n - 1));
  return x * square / 6.0 * sum;
}

}  // namespace

Response::Response(const Layer& layer)
    : layer_(layer),
      mu_(layer.modulus * (1 - layer.poisson) / (1 - layer.base_poisson)),
      k1_(3 - 4 * layer.poisson),
      k2_(3 - 4 * layer.base_poisson) {}

double Response::reach() const {
  constexpr double share = 0.7;
  const double of_thickness = layer_.bonded ? 1.4 - 0.9 * layer_.poisson : 2.3;
  return share * (layer_.rigid_base ? of_thickness : std::min(of_thickness, std::cbrt(6 / layer_.modulus)));
}

template <class Number> Number Response::f(Number s) const {
  if (s == 0.0) return long_waves();
  if (std::real(s) > 300) return short_waves();
  const bool small = std::abs(s) < 0.5;
  const Number e = std::exp(-2.0 * s), s_e = 4.0 * s * e;
  const Number rest = small ? 2.0 * std::sinh(s) * std::exp(-s) : 1.0 - e;
  const Number a = small ? 4.0 * e * sinh_beyond(s) * (std::sinh(s) + s) : rest * rest - s * s_e;
  const Number b = small ? 2.0 * e * sinh_beyond(2.0 * s) : rest * (1.0 + e) - s_e;
  const Number c = rest * (1.0 + e) + s_e;
  const double m = layer_.modulus;
  if (layer_.rigid_base && !layer_.bonded) return rest * rest / (m * c);
  if (layer_.rigid_base) return (k1_ * b + (k1_ - 1) * s_e) / (m * (k1_ * (1.0 + e * e) + s * s_e + (1 + k1_ * k1_) * e));
  if (!layer_.bonded) return (rest * rest / m + c) / (c + m * a);
  const double k = mu_ - 1, l = mu_ * k2_ - k1_;
  return (mu_ * (1 + k1_) * (1 + k2_) + l * k * b + k * (1 + 2 * mu_ * k2_ - k1_) * s_e) /
         (m * (k * (1 + mu_ * k2_) * a + (1 + k1_) * (1 + k1_ + rest * (l + k * e))));
}

template double Response::f(double) const;
template std::complex<double> Response::f(std::complex<double>) const;

}  // namespace rc::kernel::layer
