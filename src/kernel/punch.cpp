// Rigid flat circular punch inscribed in a square cell: Johnson, Contact Mechanics (1985), section 3.4(b); Bemporad & Paggi
// (2015), eq. (9).
#include <cmath>
#include <numbers>

#include "kernel/kernels.h"

namespace rc::kernel {

namespace {

// Under a force F the surface moves by 2F/(pi E* delta) arcsin(delta/(2r)) outside a punch of diameter delta; here F is delta^2.
void fill_punch(double diameter, double self, const Window& window, double* out) {
  const double factor = 2 * diameter / std::numbers::pi;
  fill(window, out, [&](double x, double y) {
    const double square = x * x + y * y;
    return square == 0 ? self : factor * std::asin(0.5 / std::sqrt(square));
  });
}

}  // namespace

// Under the punch, arcsin(1) = pi/2 gives F/(E* delta).
void punch(double hx, double, const Window& window, double* out) { fill_punch(hx, hx, window, out); }

// Eq. (9) as printed leaves arcsin(1) out of the self term: 36 % too small. Never the default: of first order with three to four
// times punch's error, ill conditioned (more than four times punch's condition number), and the off-diagonal entries of its
// inverse are so far from non-positive that the greedy method often drops points that carry pressure.
void eq9(double hx, double, const Window& window, double* out) { fill_punch(hx, 2 * hx / std::numbers::pi, window, out); }

}  // namespace rc::kernel
