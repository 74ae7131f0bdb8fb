// Uniform pressure on the disc inscribed in a square cell, of the same force as unit pressure on the cell: Johnson, Contact
// Mechanics (1985), section 3.4(a).
#include <numbers>

#include "kernel/kernels.h"
#include "kernel/radial.h"

namespace rc::kernel {

// Outside a disc of radius a under force F the deflection is, with k = a/r and complete elliptic integrals,
//   F/(pi E* r) 4/(pi k^2) [E(k) - (1 - k^2) K(k)] = F/(pi E* r) sum_j (a_j^2 / (j + 1)) k^(2j),  a_j = (2j)! / (4^j j!^2).
// No other centre is nearer than k = 1/2; the bracket would cancel far away.
void disc(double hx, double, const Window& window, double* out) {
  std::array<double, RadialSeries::terms> c;
  double a = 1;
  for (int j = 0; j < RadialSeries::terms; ++j) {
    c[j] = a * a / (j + 1);
    a *= (2 * j + 1.0) / (2 * j + 2);
  }
  fill_radial(RadialSeries(c), 2 * hx / std::numbers::pi, 4 * hx / std::numbers::pi, window, out);
}

}  // namespace rc::kernel
