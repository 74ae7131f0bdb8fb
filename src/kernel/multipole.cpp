#include "kernel/multipole.h"

#include <cmath>

namespace rc::kernel {

namespace {

constexpr double tolerance = 1e-16;  // of the truncated sum, relative

}  // namespace

Multipole::Multipole(const Density& along_x, const Density& along_y) {
  std::array<double, 2 * order + 1> a{1};
  for (int j = 1; j <= 2 * order; ++j) a[j] = a[j - 1] * (2 * j - 1) / (2 * j);

  std::array<double, order + 1> radial_moment{};             // mean of |s|^(2k+2)
  std::array<std::array<double, order + 1>, order + 1> c{};  // c_kl
  for (int iy = 0; iy < along_y.size; ++iy)
    for (int ix = 0; ix < along_x.size; ++ix) {
      const double x = along_x.node[ix], y = along_y.node[iy];
      if (x < 0 || y < 0) continue;  // nodes come in pairs of both signs
      const double square = x * x + y * y, cosine = (x - y) * (x + y) / square;
      std::array<double, order + 1> chebyshev{1, cosine};
      for (int l = 2; l <= order; ++l) chebyshev[l] = 2 * cosine * chebyshev[l - 1] - chebyshev[l - 2];
      double power = 4 * along_x.weight[ix] * along_y.weight[iy];
      for (int k = 0; k <= order; ++k) {
        for (int l = 0; l <= k; ++l)  // +l and -l share T_l
          c[k][l] += (l == 0 ? 1 : 2) * a[k - l] * a[k + l] * power * chebyshev[l];
        power *= square;
        radial_moment[k] += power;
      }
    }

  // |P_n| <= 1, so that the first term left out is at most radial_moment / |x|^(2k+2), and the rest is far smaller.
  for (int k = 0; k <= order; ++k) reach_[k] = std::pow(radial_moment[k] / tolerance, 1.0 / (k + 1));

  // Powers cancel like 2^k eps in the term k, which is smaller than 25^(-k) of the sum wherever the expansion is used.
  std::array<std::array<double, order + 1>, order + 1> powers_of{};  // T_l by powers of its argument
  powers_of[0][0] = powers_of[1][1] = 1;
  for (int l = 2; l <= order; ++l)
    for (int i = 0; i <= l; ++i) powers_of[l][i] = (i > 0 ? 2 * powers_of[l - 1][i - 1] : 0) - powers_of[l - 2][i];
  for (int k = 0; k <= order; ++k)
    for (int l = 0; l <= k; ++l)
      for (int i = 0; i <= l; ++i) power_[k][i] += c[k][l] * powers_of[l][i];
}

void Multipole::mean_inverse_distance(const Run& square, const Run& t, double nearest, Run& out) const {
  int last = 0;
  while (last < order && nearest < reach_[last]) ++last;

  Run inverse, sum{}, polynomial;
  for (int i = 0; i < run_length; ++i) inverse[i] = 1 / square[i];
  for (int k = last; k >= 0; --k) {
    polynomial.fill(power_[k][k]);
    for (int l = k - 1; l >= 0; --l)
      for (int i = 0; i < run_length; ++i) polynomial[i] = polynomial[i] * t[i] + power_[k][l];
    for (int i = 0; i < run_length; ++i) sum[i] = sum[i] * inverse[i] + polynomial[i];
  }
  for (int i = 0; i < run_length; ++i) out[i] = sum[i] * std::sqrt(inverse[i]);
}

}  // namespace rc::kernel
