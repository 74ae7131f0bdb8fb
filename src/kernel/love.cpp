// Uniform pressure on a rectangular cell, deflection at the centre of another one: A. E. H. Love, Phil. Trans. R. Soc. A 228
// (1929) 377; Johnson, Contact Mechanics (1985), eq. (3.25).
#include <cmath>

#include "kernel/kernels.h"
#include "kernel/rectangle.h"

namespace rc::kernel {

namespace {

// The integral of 1/r over [0, x] x [0, y], odd in both; asinh in place of the usual logarithms keeps the digits.
double integral(double x, double y) {
  if (x == 0 || y == 0) return 0;
  return x * std::asinh(y / std::abs(x)) + y * std::asinh(x / std::abs(y));
}

double corner_term(double x, double y, double side) {
  const double left = x - 0.5, right = x + 0.5, lower = y - side / 2, upper = y + side / 2;
  return (integral(right, upper) - integral(left, upper) - integral(right, lower) + integral(left, lower)) / side;
}

double line_term(double x, double y) { return std::asinh((x + 0.5) / y) - std::asinh((x - 0.5) / y); }

}  // namespace

void love(double hx, double hy, const Window& window, double* out) {
  fill_rectangle({box, line_term, corner_term}, hx, hy, window, out);
}

}  // namespace rc::kernel
