// The split of 1/r (as in Ewald's method; with Kaiser-Bessel functions and coarse grids): 1/r = Phi(r/rc)/r + (1 - Phi(r/rc))/r,
// Phi(x) = int_0^x I0(c sqrt(1-t^2)) dt divided by the same integral to 1, and Phi = 1 beyond. The first part is smooth and taken
// over a grid whose cells are `spacing` cells of the grid wide; the second vanishes beyond rc.
#pragma once

#include <array>
#include <cstdint>

namespace rc_split {

// What decides on the accuracy, in units of the coarse grid: independent of its spacing.
struct Scheme {
  int nodes;     // coarse nodes along each axis that a point spreads to; even
  double shape;  // c
  double reach;  // rc
  int bend;      // nodes beyond the grid over which the circular kernel is made even and smooth
};

// Errors relative to the largest product: about 3e-6 and 1e-11.
template <class T> inline constexpr Scheme scheme{};
template <> inline constexpr Scheme scheme<float>{8, 9.0, 3.6, 16};
template <> inline constexpr Scheme scheme<double>{14, 20.0, 9.0, 24};

// Modified Bessel function of the first kind of order 0.
double bessel_i0(double x);

// Phi(x)/x as a polynomial of x^2, 0 <= x <= 1.
class Smoothed {
 public:
  explicit Smoothed(double shape);

  double operator()(double x_square) const {
    const double t = 4 * x_square - 2;  // twice the argument of the Chebyshev polynomials
    double b1 = 0, b2 = 0;
    for (int k = degree; k > 0; --k) {
      const double b = c_[static_cast<std::size_t>(k)] + t * b1 - b2;
      b2 = b1;
      b1 = b;
    }
    return c_[0] + 0.5 * t * b1 - b2;
  }

 private:
  static constexpr int degree = 32;
  std::array<double, degree + 1> c_{};
};

// phi(t) = I0(beta sqrt(1 - (2t/q)^2)) / I0(beta), |t| <= q/2 coarse cells, and its Fourier transform (Kaiser and Schafer 1980).
class Window {
 public:
  // `fraction`: of the coarse cell's wave number 2 pi, what the smooth part occupies: shape/reach, where cells are square.
  Window(int nodes, double fraction);

  double operator()(double t) const;
  double transform(double theta) const;

 private:
  double q_, beta_, i0_;
};

}  // namespace rc_split
