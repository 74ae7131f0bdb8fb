// A finite matrix is a section of that of the whole lattice, whose quadratic form is the mean over all waves k of
// |x(k)|^2 sigma(k): its eigenvalues lie above the infimum of the symbol sigma, wherever the points are. For rectangular cells
//   sigma(k) = sum over q = k + 2 pi (m/hx, n/hy) of 2/|q| [sinc(qx hx/2) sinc(qy hy/2)]^power,  power 1 love, 2 galerkin.
// With 2/|q| = (4/sqrt(pi)) integral over z of exp(-qx^2 z^2) exp(-qy^2 z^2) it is an integral of products F(kx, z) F(ky, z).
// F is positive and decreases from k = 0 to pi/h for every z, for both powers, and love's is nowhere below galerkin's: the least
// value is at (pi/hx, pi/hy) for every aspect ratio, and galerkin's symbol is a lower bound of love's.
#include "kernel/lowest_eigenvalue.h"

#include <cmath>
#include <cstring>
#include <numbers>

namespace rc::kernel {

namespace {

// sigma(pi/hx, pi/hy), from below. Galerkin: all terms are positive. Love: the signs of the factors of F alternate and their
// sizes decrease, so that a sum of an even number of terms is below the limit in both directions.
double corner_of_symbol(double hx, double hy, int power) {
  constexpr int last = 128;  // odd numbers up to here; 64 terms
  constexpr double pi = std::numbers::pi;
  double sum = 0;
  for (int t = last - 1; t > 0; t -= 2)
    for (int s = last - 1; s > 0; s -= 2) {
      const double sign = (s + t) % 4 == 2 ? 1 : -1;
      const double sincs = sign * 4 / (pi * pi * s * t);
      sum += 8 / (pi * std::hypot(s / hx, t / hy)) * (power == 1 ? sincs : sincs * sincs);
    }
  return sum;
}

struct SquareCells {
  const char* name;
  double lowest;  // of the symbol, at (pi, pi), for cells of side 1
  double share;   // least ratio of the symbol to galerkin's
};
// Sums over 10^6 offsets on 33 x 33 waves, rounded down: disc 0.72908, 1 (as k tends to 0); eq9 0.08139, 0.23919 at (pi, pi);
// punch 0.44477, 0.98093 at (0.16 pi, 0.16 pi).
constexpr SquareCells square_cells[] = {{"disc", 0.728, 0.99}, {"eq9", 0.081, 0.235}, {"punch", 0.444, 0.97}};

const SquareCells* find_square(const Kernel& kernel) {
  for (const SquareCells& each : square_cells)
    if (std::strcmp(each.name, kernel.name) == 0) return &each;
  return nullptr;
}

bool is(const Kernel& kernel, const char* name) { return std::strcmp(kernel.name, name) == 0; }

// Round-off of the coefficients moves eigenvalues by far less.
constexpr double slack = 1 - 1e-6;

}  // namespace

double lowest_eigenvalue(const Kernel& kernel, double hx, double hy) {
  if (const SquareCells* known = find_square(kernel)) return known->lowest * hx;
  if (is(kernel, "love")) return slack * corner_of_symbol(hx, hy, 1);
  if (is(kernel, "galerkin")) return slack * corner_of_symbol(hx, hy, 2);
  return 0;
}

double share_of_galerkin(const Kernel& kernel) {
  if (const SquareCells* known = find_square(kernel)) return known->share;
  return is(kernel, "love") || is(kernel, "galerkin") ? slack : 0;
}

// The eigenvalue of the grid's shortest wave.
double lowest_wave_eigenvalue(const Kernel&, double hx, double hy, std::int64_t nx, std::int64_t ny) {
  if (nx == 1 && ny == 1) return 0;
  const std::int64_t kx = nx / 2, ky = ny / 2;
  const double wx = static_cast<double>(kx) / (static_cast<double>(nx) * hx);
  const double wy = static_cast<double>(ky) / (static_cast<double>(ny) * hy);
  return slack / (std::numbers::pi * std::hypot(wx, wy));
}

}  // namespace rc::kernel
