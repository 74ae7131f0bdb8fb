// Uniform pressure on the disc inscribed in a square cell, of the same force as unit pressure on the cell: Johnson, Contact
// Mechanics (1985), section 3.4(a).
#include <array>
#include <cmath>
#include <numbers>

#include "kernel/kernels.h"

namespace rc::kernel {

namespace {

// Outside a disc of radius a under force F the deflection is, with k = a/r and complete elliptic integrals,
//   F/(pi E* r) 4/(pi k^2) [E(k) - (1 - k^2) K(k)] = F/(pi E* r) sum_j (a_j^2 / (j + 1)) k^(2j),  a_j = (2j)! / (4^j j!^2).
// No other centre is nearer than k = 1/2, where the sum needs no more than `terms` terms; the bracket would cancel far away.
class InverseDistance {
 public:
  InverseDistance() {
    double a = 1;
    for (int j = 0; j < terms; ++j) {
      c_[j] = a * a / (j + 1);
      a *= (2 * j + 1.0) / (2 * j + 2);
    }
    // The first term left out is a fraction 1e-16 of the sum from here on.
    for (int j = 0; j < terms; ++j) reach_[j] = 0.25 * std::pow(1e16, 1.0 / (j + 1));
  }

  // At the given distance squared, in cells.
  double operator()(double square) const {
    const double inverse = 1 / square, k_square = 0.25 * inverse;
    int j = 0;
    while (j + 1 < terms && square < reach_[j]) ++j;
    double sum = 0;
    for (; j >= 0; --j) sum = sum * k_square + c_[j];
    return sum * std::sqrt(inverse);
  }

 private:
  static constexpr int terms = 24;

  std::array<double, terms> c_{};
  std::array<double, terms> reach_{};  // distance squared from which the terms up to j suffice
};

}  // namespace

void disc(double hx, double, const Window& window, double* out) {
  const InverseDistance inverse_distance;
  fill(window, out, [&](double x, double y) {
    const double square = x * x + y * y;
    return square == 0 ? 4 * hx / std::numbers::pi : hx / std::numbers::pi * inverse_distance(square);
  });
}

}  // namespace rc::kernel
