#include "kernel/semi_periodic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <functional>
#include <map>
#include <numbers>
#include <vector>

#include "kernel/kernels.h"
#include "kernel/lowest_eigenvalue.h"

namespace rc::kernel {

namespace {

using std::numbers::egamma;
using std::numbers::pi;

constexpr double longest_decay = 38;         // waves that have decayed by exp(-38) do not count
constexpr double nearest = 1.0 / 3;          // of the period: images are summed nearer, waves farther away
constexpr std::int64_t least_images = 4;     // on either side
constexpr double clearance = 8;              // images are summed up to this many times the farthest point of the cells at hand
constexpr double below_rounding = 1 - 1e-6;  // round-off of the coefficients moves eigenvalues by far less

// The mean of ln(R/|y - t|) over a cell's side |t| <= h/2.
double mean_logarithm(double R, double y, double h) {
  const double half = h / 2;
  if (y == 0) return std::log(R / half) + 1;
  if (y < 4 * h) {
    const double a = y - half, b = y + half;
    return 1 - (b * std::log(b / R) - a * std::log(a / R)) / h;
  }
  const double square = (half / y) * (half / y);
  double sum = 0, power = 1;
  for (int n = 1; n < 12; ++n) {
    power *= square;
    sum += power / (2 * n * (2 * n + 1));
  }
  return std::log(R / y) + sum;
}

// The mean of K0(q |y - t|) over a cell's side |t| <= h/2, by the trapezoidal rule for the integral of exp(-z cosh s) / cosh s
// over s, whose error is exp(-pi^2 / step).
double mean_bessel(double q, double y, double h) {
  constexpr double step = 0.25;
  const bool own = y == 0;
  const double a = own ? 0 : q * (y - h / 2), b = own ? q * h / 2 : q * (y + h / 2);
  double sum = 0;
  for (int j = 0;; ++j) {
    const double c = std::cosh(step * j), decay = std::exp(-a * c);
    const double term = -decay * std::expm1(-(b - a) * c) / c;
    sum += j == 0 ? term / 2 : term;
    if (a * c > longest_decay || term < 1e-18 * sum) break;
  }
  return (own ? 2 : 1) * step * sum / (q * h);
}

bool is_love(const Kernel& kernel) { return std::strcmp(kernel.name, "love") == 0; }

// The symbol of spectral at the shortest waves of both axes, from below: along the axis that repeats there is one wave, across it
// the sum of aliases alternates in sign.
double corner_of_waves(double h_along, double h_across) {
  double sum = 0;
  for (int t = 127; t > 0; t -= 2) sum += (t % 4 == 1 ? 8 : -8) / (pi * pi * t * std::hypot(1 / h_along, t / h_across));
  return sum;
}

double sinc(double x) { return x == 0 ? 1 : std::sin(x) / x; }

// The means of (x - s)^(2 i), i = 0, 1, ..., over a cell's side |s| <= h/2.
template <std::size_t count> void mean_powers(double x, double h, std::array<double, count>& out) {
  const double square = x * x, quarter = h * h / 4;
  for (std::size_t i = 0; i < count; ++i) {
    // sum over j of binomial(2 i, 2 j) x^(2 i - 2 j) (h/2)^(2 j) / (2 j + 1), by Horner's rule in x^2
    const int power = 2 * static_cast<int>(i);
    double sum = 1, term = 1;
    for (int j = 2; j <= power; j += 2) {
      term *= static_cast<double>((power - j + 2) * (power - j + 1)) / ((j - 1) * j) * quarter;
      sum = sum * square + term / (j + 1);
    }
    out[i] = sum;
  }
}

// The images beyond the nearest M on either side, less the datum: for |x| << M L,
//   2/L (gamma - H_M + ln(R/(2 L))) + 2/L sum over even l >= 2 of zeta_M(l + 1) / L^l r^l P_l(x/r),
// zeta_M(s) the sum over m > M of m^-s. In the plane r^l P_l = sum over j of c_lj x^(l - 2 j) y^(2 j).
class FarImages {
 public:
  FarImages(const Strip& strip, std::int64_t images) : strip_(strip) {
    const double L = strip.period(), M = static_cast<double>(images);
    double harmonic = 0;
    for (std::int64_t m = images; m > 0; --m) harmonic += 1 / static_cast<double>(m);
    constant_ = 2 / L * (egamma - harmonic + std::log(strip.datum() / (2 * L)));
    unit_ = (M + 1) * L;
    for (std::size_t half = 1; half < terms; ++half) {
      const int l = 2 * static_cast<int>(half);
      weight_[half] = 2 / L * tail(l + 1, M) * std::pow(M + 1, l);
      // The coefficients of P_l(t): a_j t^(l - 2 j), of which x^(l - 2 j) (x^2 + y^2)^j makes the solid harmonic.
      double a = 1;
      for (int i = 1; i <= l; ++i) a *= (2.0 * i - 1) / i;
      for (int j = 0; j <= l / 2; ++j) {
        double binomial = 1;
        for (int k = 0; k <= j; ++k) {
          power_[half][static_cast<std::size_t>(k)] += a * binomial;
          binomial *= static_cast<double>(j - k) / (k + 1);
        }
        a *= -static_cast<double>((l - 2 * j) * (l - 2 * j - 1)) / (2.0 * (j + 1) * (2 * l - 2 * j - 1));
      }
    }
  }
  using Row = std::array<double, 10>;
  Row row(double y) const {
    Row powers;
    mean_powers(y / unit_, strip_.h_across / unit_, powers);
    return powers;
  }
  // The mean over a cell at x of this row.
  double at(double x, const Row& across) const {
    Row powers;
    mean_powers(x / unit_, strip_.h_along / unit_, powers);
    double sum = 0;
    for (std::size_t half = terms - 1; half > 0; --half) {
      double harmonic = 0;
      for (std::size_t k = 0; k <= half; ++k) harmonic += power_[half][k] * powers[half - k] * across[k];
      sum += weight_[half] * harmonic;
    }
    return constant_ + sum;
  }

 private:
  static constexpr std::size_t terms = std::tuple_size_v<Row>;

  // The sum over m > M of m^-s, by Euler and Maclaurin from M + 40.5 on.
  static double tail(int s, double M) {
    const double from = M + 40.5;
    double sum = 0;
    // NOLINTNEXTLINE(clang-analyzer-security.FloatLoopCounter): whole numbers
    for (double m = M + 40; m > M; --m) sum += std::pow(m, -s);
    const double power = std::pow(from, -s);
    return sum + power * (from / (s - 1) - s / (24 * from) + 7.0 * s * (s + 1) * (s + 2) / (5760 * from * from * from));
  }

  const Strip strip_;
  double constant_ = 0, unit_ = 1;
  Row weight_{};
  std::array<Row, terms> power_{};
};

// Sums of images for love, of waves for both, along the axis that repeats.
class Rows {
 public:
  Rows(const Strip& strip, bool love) : strip_(strip), love_(love), cosines_(cosines_of_a_turn(strip.n_along)) {}

  // Row iy of offsets first .. first + count - 1 along the axis.
  void fill(std::int64_t iy, std::int64_t first, std::int64_t count, double* out) {
    const double y = static_cast<double>(iy) * strip_.h_across;
    if (love_ && (iy == 0 || y < nearest * strip_.period()))
      from_images(iy, y, first, count, out);
    else
      from_waves(y, first, count, out);
  }

 private:
  double cell() const { return strip_.h_along * strip_.h_across / pi; }

  void from_waves(double y, std::int64_t first, std::int64_t count, double* out) const {
    const double L = strip_.period(), h = strip_.h_across;
    const std::int64_t n = strip_.n_along;
    std::fill_n(out, count, cell() * 2 / L * mean_logarithm(strip_.datum(), y, h));
    for (std::int64_t k = 1; love_ || 2 * k <= n; ++k) {
      const double q = 2 * pi * static_cast<double>(k) / L;
      if (y > 0 && q * (y - h / 2) > longest_decay) break;
      const double share = love_ ? sinc(q * strip_.h_along / 2) : 2 * k == n ? 0.5 : 1;
      const double weight = cell() * 4 / L * share * mean_bessel(q, y, h);
      const std::int64_t stride = k % n;
      std::int64_t at = first % n * stride % n;
      for (std::int64_t i = 0; i < count; ++i) {
        out[i] += weight * cosines_[static_cast<std::size_t>(at)];
        at += stride;
        if (at >= n) at -= n;
      }
    }
  }

  void from_images(std::int64_t iy, double y, std::int64_t first, std::int64_t count, double* out) {
    const std::int64_t n = strip_.n_along;
    const double L = strip_.period(), reach = std::hypot((L + strip_.h_along) / 2, y + strip_.h_across / 2);
    const auto images = std::max(least_images, static_cast<std::int64_t>(std::ceil(clearance * reach / L)) - 1);
    const FarImages& far = beyond(images);
    const FarImages::Row powers = far.row(y);
    // Offsets i and n - i are the same.
    const auto folded = [&](std::int64_t i) { return std::min(i % n, n - i % n); };
    std::int64_t low = n, high = 0;
    for (std::int64_t i = first; i < first + count; ++i) {
      low = std::min(low, folded(i));
      high = std::max(high, folded(i));
    }
    const std::int64_t width = high - low + 1;
    std::vector<double> sum(static_cast<std::size_t>(width)), image(sum.size());
    for (std::int64_t m = 0; m <= images; ++m) {
      love(strip_.h_along, strip_.h_across, {m * n + low, iy, width, 1}, image.data());
      std::transform(sum.begin(), sum.end(), image.begin(), sum.begin(), std::plus<>());
      if (m == 0) continue;
      love(strip_.h_along, strip_.h_across, {m * n - high, iy, width, 1}, image.data());
      std::transform(sum.begin(), sum.end(), image.rbegin(), sum.begin(), std::plus<>());
    }
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t at = folded(first + i);
      out[i] = sum[static_cast<std::size_t>(at - low)] + cell() * far.at(static_cast<double>(at) * strip_.h_along, powers);
    }
  }

  const FarImages& beyond(std::int64_t images) { return beyond_.try_emplace(images, strip_, images).first->second; }

  const Strip strip_;
  const bool love_;
  const std::vector<double> cosines_;  // of the waves at the cells of a period
  std::map<std::int64_t, FarImages> beyond_;
};

}  // namespace

Strip strip_of(const rc_system& grid) {
  if (grid.boundary == RC_BOUNDARY_PERIODIC_X) return {grid.nx, grid.ny, grid.hx, grid.hy};
  return {grid.ny, grid.nx, grid.hy, grid.hx};
}

void semi_periodic_coefficients(const Kernel& kernel, const rc_system& grid, const Window& window, double* out) {
  const bool along_x = grid.boundary == RC_BOUNDARY_PERIODIC_X;
  Rows rows(strip_of(grid), is_love(kernel));
  if (along_x) {
    for (std::int64_t iy = 0; iy < window.my; ++iy)
      rows.fill(window.first_y + iy, window.first_x, window.mx, out + iy * window.mx);
    return;
  }
  std::vector<double> column(static_cast<std::size_t>(window.my));
  for (std::int64_t ix = 0; ix < window.mx; ++ix) {
    rows.fill(window.first_x + ix, window.first_y, window.my, column.data());
    for (std::int64_t iy = 0; iy < window.my; ++iy) out[iy * window.mx + ix] = column[static_cast<std::size_t>(iy)];
  }
}

double share_of_galerkin(const Strip& strip) { return below_rounding * (1 - 0.5 / static_cast<double>(strip.n_across)); }

double lowest_eigenvalue(const Kernel& kernel, const Strip& strip) {
  const double least = is_love(kernel) ? lowest_eigenvalue(kernel, strip.h_along, strip.h_across)
                                       : below_rounding * corner_of_waves(strip.h_along, strip.h_across);
  return share_of_galerkin(strip) * least;
}

double punch_stiffness(const Strip& strip, double width) {
  return pi * strip.period() / (2 * std::log(4 * strip.datum() / width));
}

}  // namespace rc::kernel
