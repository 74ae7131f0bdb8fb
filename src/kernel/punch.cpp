// Rigid flat circular punch inscribed in a square cell: Johnson, Contact Mechanics (1985), section 3.4(b); Bemporad & Paggi
// (2015), eq. (9).
#include <numbers>

#include "kernel/kernels.h"
#include "kernel/radial.h"

namespace rc::kernel {

namespace {

// Under a force F the surface moves by 2F/(pi E* delta) arcsin(delta/(2r)) outside a punch of diameter delta; here F is delta^2.
// arcsin k = sum over j of a_j / (2j + 1) k^(2j+1), a_j = (2j)! / (4^j j!^2).
void fill_punch(double diameter, double self, const Window& window, double* out) {
  std::array<double, RadialSeries::terms> c;
  double a = 1;
  for (int j = 0; j < RadialSeries::terms; ++j) {
    c[j] = a / (2 * j + 1);
    a *= (2 * j + 1.0) / (2 * j + 2);
  }
  fill_radial(RadialSeries(c), 2 * diameter / std::numbers::pi, self, window, out);
}

}  // namespace

// Under the punch, arcsin(1) = pi/2 gives F/(E* delta).
void punch(double hx, double, const Window& window, double* out) { fill_punch(hx, hx, window, out); }

// Eq. (9) as printed leaves arcsin(1) out of the self term: 36 % too small. Never the default: of first order with three to four
// times punch's error, ill conditioned (more than four times punch's condition number), and the off-diagonal entries of its
// inverse are so far from non-positive that the greedy method often drops points that carry pressure.
void eq9(double hx, double, const Window& window, double* out) { fill_punch(hx, 2 * hx / std::numbers::pi, window, out); }

}  // namespace rc::kernel
