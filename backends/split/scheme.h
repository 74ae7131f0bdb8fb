// The split of 1/r (as in Ewald's method; with Kaiser-Bessel functions and coarse grids): 1/r = Phi(r/rc)/r + (1 - Phi(r/rc))/r,
// Phi(x) = int_0^x I0(c sqrt(1-t^2)) dt divided by the same integral to 1, and Phi = 1 beyond. The first part is smooth and taken
// over a grid whose cells are `spacing` cells of the grid wide; the second vanishes beyond rc.
#pragma once

#include <array>
#include <cstdint>

namespace rc_split {

// The parameters that decide on the accuracy. They are in units of the coarse grid, so its spacing does not matter.
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

  // Several at once, because in a single recurrence every step waits for the one before.
  static constexpr std::size_t lanes = 8;
  void operator()(const double* x_square, double* out) const {
    double t[lanes], b1[lanes] = {}, b2[lanes] = {};
    for (std::size_t i = 0; i < lanes; ++i) t[i] = 4 * x_square[i] - 2;  // twice the argument of the Chebyshev polynomials
    for (std::size_t k = degree; k > 0; --k)
      for (std::size_t i = 0; i < lanes; ++i) {
        const double b = c_[k] + t[i] * b1[i] - b2[i];
        b2[i] = b1[i];
        b1[i] = b;
      }
    for (std::size_t i = 0; i < lanes; ++i) out[i] = c_[0] + 0.5 * t[i] * b1[i] - b2[i];
  }

 private:
  static constexpr std::size_t degree = 32;
  std::array<double, degree + 1> c_{};
};

// phi(t) = I0(beta sqrt(1 - (2t/q)^2)) / I0(beta), |t| <= q/2 coarse cells, and its Fourier transform (Kaiser and Schafer 1980).
class Window {
 public:
  // fraction: how much of the coarse cell's wave number 2 pi the smooth part occupies; shape/reach, if cells are square.
  Window(int nodes, double fraction);

  double operator()(double t) const;
  double transform(double theta) const;

 private:
  double q_, beta_, i0_;
};

}  // namespace rc_split
