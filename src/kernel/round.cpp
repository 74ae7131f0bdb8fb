// Kernels of round patches on square cells, which depend on the distance alone: sums of c_j k^(2j+1), k = a/r, a the patch's
// radius of half a cell. No other centre is nearer than k = 1/2; closed forms would cancel far away.
#include <array>
#include <cmath>
#include <numbers>

#include "kernel/kernels.h"

namespace rc::kernel {

namespace {

constexpr int terms = 26;

// Fills factor times the sum with c_j = coefficient(j, a_j), a_j = (2j)! / (4^j j!^2), none larger than c_0, and `self` at the
// origin.
template <class Coefficient>
void fill_round(double factor, double self, const Window& window, double* out, const Coefficient& coefficient) {
  std::array<double, terms> c, reach;  // reach: distance squared, in cells, from which the terms up to j suffice
  double a = 1;
  for (int j = 0; j < terms; ++j) {
    c[j] = coefficient(j, a);
    a *= (2 * j + 1.0) / (2 * j + 2);
    reach[j] = 0.25 * std::pow(1e16, 1.0 / (j + 1));  // the first term left out is at most 1e-16 of the sum
  }
  fill(window, out, [&](double x, double y, Run& values) {
    const double nearest = x * x + y * y;
    int last = 0;
    while (last + 1 < terms && nearest < reach[last]) ++last;

    Run k_square, sum{};
    for (int i = 0; i < run_length; ++i) k_square[i] = 0.25 / ((x + i) * (x + i) + y * y);
    for (int j = last; j >= 0; --j)
      for (int i = 0; i < run_length; ++i) sum[i] = sum[i] * k_square[i] + c[j];
    for (int i = 0; i < run_length; ++i) values[i] = sum[i] * std::sqrt(k_square[i]) * factor;
    if (x == 0 && y == 0) values[0] = self;
  });
}

// Under a force F the surface moves by 2F/(pi E* delta) arcsin(delta/(2r)) outside a rigid flat punch of diameter delta: Johnson,
// Contact Mechanics (1985), section 3.4(b); here F is delta^2. arcsin k = sum over j of a_j / (2j + 1) k^(2j+1).
void fill_punch(double diameter, double self, const Window& window, double* out) {
  fill_round(2 * diameter / std::numbers::pi, self, window, out, [](int j, double a) { return a / (2 * j + 1); });
}

}  // namespace

// Uniform pressure on the disc inscribed in a cell, of the same force as unit pressure on the cell: Johnson, section 3.4(a).
// Outside a disc of radius a under force F the deflection is, with complete elliptic integrals,
//   F/(pi E* r) 4/(pi k^2) [E(k) - (1 - k^2) K(k)] = F/(pi E* r) sum_j (a_j^2 / (j + 1)) k^(2j).
void disc(double hx, double, const Window& window, double* out) {
  fill_round(2 * hx / std::numbers::pi, 4 * hx / std::numbers::pi, window, out, [](int j, double a) { return a * a / (j + 1); });
}

// Under the punch, arcsin(1) = pi/2 gives F/(E* delta).
void punch(double hx, double, const Window& window, double* out) { fill_punch(hx, hx, window, out); }

// Bemporad & Paggi (2015), eq. (9), as printed leaves arcsin(1) out of the self term: 36 % too small. Never the default: of first
// order with three to four times punch's error, ill conditioned (more than four times punch's condition number), and the
// off-diagonal entries of its inverse are so far from non-positive that the greedy method often drops points that carry pressure.
void eq9(double hx, double, const Window& window, double* out) { fill_punch(hx, 2 * hx / std::numbers::pi, window, out); }

}  // namespace rc::kernel
