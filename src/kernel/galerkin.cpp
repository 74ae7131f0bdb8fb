// Uniform pressure on a rectangular cell, mean deflection over another one: the second difference, in x and in y, of a function
// whose derivative G_xxyy is 1/r (Love's integral, integrated once more over the receiving cell).
#include <cmath>

#include "kernel/kernels.h"
#include "kernel/rectangle.h"

namespace rc::kernel {

namespace {

template <class F> double second_difference(F f, double at, double step) {
  return (f(at + step) - f(at)) - (f(at) - f(at - step));
}

// G = x^2 y/2 asinh(y/x) + x y^2/2 asinh(x/y) - (r^3 - x^3)/6. The x^3 drops out of the difference in y; taking it off here
// keeps the digits in a narrow cell, where y << x. Even in x and y.
double potential(double x, double y) {
  x = std::abs(x);
  y = std::abs(y);
  if (y == 0) return 0;
  const double r = std::hypot(x, y);
  const double cubes = y * y * (r * r + r * x + x * x) / (r + x);
  if (x == 0) return -cubes / 6;
  return x * y / 2 * (x * std::asinh(y / x) + y * std::asinh(x / y)) - cubes / 6;
}

double closed(double x, double y, double side) {
  const auto in_x = [&](double v) { return second_difference([v](double u) { return potential(u, v); }, x, 1); };
  return second_difference(in_x, y, side) / (side * side);
}

double on_line(double x, double y) {
  return second_difference([y](double u) { return u * std::asinh(u / y) - std::hypot(u, y); }, x, 1);
}

}  // namespace

void galerkin(double hx, double hy, const Window& window, double* out) {
  fill_rectangle({tent, on_line, closed}, hx, hy, window, out);
}

}  // namespace rc::kernel
