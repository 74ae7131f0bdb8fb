// Rigid flat circular punch inscribed in a square cell: Johnson, Contact Mechanics (1985), section 3.4(b); Bemporad & Paggi
// (2015), eq. (9).
#include <cmath>
#include <numbers>

#include "kernel/circle.h"
#include "kernel/kernels.h"

namespace rc::kernel {

namespace {

// A force F on a punch of diameter delta moves the surface by 2F/(pi E* delta) arcsin(delta/(2r)) outside it; here F is
// delta^2 and the argument (r/delta)^2.
double outside(double square) {
  return square == 0 ? 0 : 2 / std::numbers::pi * std::asin(0.5 / std::sqrt(square));
}

}  // namespace

// Under the punch, arcsin(1) gives F/(E* delta).
void punch(double hx, double, std::int64_t mx, std::int64_t my, double* out) { fill_circle(hx, 1, outside, mx, my, out); }

// Eq. (9) as printed leaves the arcsin(1) = pi/2 out of the self term: 36 % too small. Never the default: of first order with
// an error three to four times punch's, ill conditioned (about four times punch's condition number), and its inverse has positive
// off-diagonal entries, so that the greedy method, exact for love and disc, drops points that carry pressure.
void eq9(double hx, double, std::int64_t mx, std::int64_t my, double* out) {
  fill_circle(hx, 2 / std::numbers::pi, outside, mx, my, out);
}

}  // namespace rc::kernel
