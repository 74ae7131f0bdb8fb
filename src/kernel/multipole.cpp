#include "kernel/multipole.h"

#include <cmath>

namespace rc::kernel {

namespace {

constexpr double tolerance = 1e-15;  // of the truncated sum, relative

// Clenshaw: sum over l = 0..degree of c_l T_l(t).
template <class Coefficients> double chebyshev_sum(const Coefficients& c, int degree, double t) {
  double b1 = 0, b2 = 0;
  for (int l = degree; l > 0; --l) {
    const double b = c[l] + 2 * t * b1 - b2;
    b2 = b1;
    b1 = b;
  }
  return c[0] + t * b1 - b2;
}

}  // namespace

Multipole::Multipole(const Density& along_x, const Density& along_y) {
  std::array<double, 2 * order + 1> a{1};
  for (int j = 1; j <= 2 * order; ++j) a[j] = a[j - 1] * (2 * j - 1) / (2 * j);

  std::array<double, order + 1> radial_moment{};  // mean of |s|^(2k+2)
  for (int iy = 0; iy < along_y.size; ++iy)
    for (int ix = 0; ix < along_x.size; ++ix) {
      const double x = along_x.node[ix], y = along_y.node[iy];
      const double square = x * x + y * y, angle = std::atan2(y, x);
      double power = along_x.weight[ix] * along_y.weight[iy];
      for (int k = 0; k <= order; ++k) {
        for (int l = 0; l <= k; ++l)  // +l and -l share T_l
          c_[k][l] += (l == 0 ? 1 : 2) * a[k - l] * a[k + l] * power * std::cos(2 * l * angle);
        power *= square;
        radial_moment[k] += power;
      }
    }

  // |P_n| <= 1, so that the first term left out is at most radial_moment / |x|^(2k+2), and the rest is far smaller.
  for (int k = 0; k <= order; ++k) reach_[k] = std::pow(radial_moment[k] / tolerance, 1.0 / (k + 1));
}

double Multipole::mean_inverse_distance(double x, double y) const {
  const double square = x * x + y * y, inverse = 1 / square;
  const double t = (x - y) * (x + y) * inverse;
  int k = 0;
  while (k < order && square < reach_[k]) ++k;

  double sum = 0;
  for (; k >= 0; --k) sum = sum * inverse + chebyshev_sum(c_[k], k, t);
  return sum * std::sqrt(inverse);
}

}  // namespace rc::kernel
