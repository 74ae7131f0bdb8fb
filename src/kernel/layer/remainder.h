// The deflection that a layer adds to that of a half-space of its own material, on free boundaries.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "kernel/layer/response.h"

namespace rc::kernel::layer {

// A unit load deflects a point at the distance r = rho t by 1/(pi E*) times that of the half-space, E2*/E1* / r, plus T(rho)/t,
//   T(rho) = integral of (f(s) - E2*/E1*) J0(s rho) over s from 0 to infinity.
// f - E2*/E1* decays as s^2 exp(-2 s): T is analytic for |Im rho| < 2.
class Remainder {
 public:
  // For distances up to `farthest`, between cells hx by hy.
  Remainder(const Response&, double hx, double hy, double farthest);

  // The mean over a receiving cell x, y away of the deflection by unit pressure on a cell [length], times E*.
  double coefficient(double x, double y) const;

 private:
  static constexpr int nodes = 16;
  using Polynomial = std::array<double, nodes>;  // by Chebyshev's polynomials
  // Between u and u + width, u = asinh(rho): T, and the integrals of T rho, T rho^2 and T rho^3 from 0.
  struct Panel {
    Polynomial value;
    std::array<Polynomial, 3> moment;
  };

  class BesselJ0 {
   public:
    BesselJ0();
    double operator()(double z) const;  // z >= 0, to round-off

   private:
    std::array<double, 16> sine_;
  };
  // T by quadrature over s, for rho up to a largest one.
  class Oscillating {
   public:
    void prepare(const Response&, double largest);
    double operator()(double rho) const;

   private:
    BesselJ0 bessel_;
    std::vector<double> s_, weighted_;  // nodes, and weight times f - E2*/E1* there
  };
  // T for rho from 40 times 1/reach() on, by turning the path of s to the imaginary axis:
  // T = 2/(pi rho) times the integral of Re(f(i z/rho) - E2*/E1*) K0(z) over z.
  class Decaying {
   public:
    Decaying();
    double operator()(const Response&, double rho) const;

   private:
    std::vector<double> z_, weighted_;
  };

  // T over rho^2 + 4, which it is analytic in but at 0: sixteen intervals an octave, powers of the distance from their middle.
  class Fast {
   public:
    void tabulate(const Remainder& exact, double farthest_rho);
    double operator()(double square) const;  // of rho

   private:
    static constexpr int degree = 8, per_octave = 16;
    static constexpr double singular = 4;
    std::vector<std::array<double, degree>> pieces_;
  };

  void tabulate(double farthest_rho, double last_moment);
  double value(double rho) const;
  std::array<double, 3> moments(double rho) const;
  double by_points(double x, double y, const double* at, const double* weight, int n) const;
  double by_angles(double x, double y) const;
  // The sides of the tent over [end - length, end + length] that is 1/length high: between end and end + side, side = +-length.
  struct Side {
    double end, side;
    double low() const { return side < 0 ? end + side : end; }
    double high() const { return side < 0 ? end : end + side; }
    double slope() const { return -1 / (side * std::abs(side)); }
    double constant() const { return 1 / std::abs(side) - end * slope(); }
  };
  double over_rectangle(Side x, Side y) const;

  Response response_;
  double t_, hx_, hy_;
  double near_ = 0;  // coefficients nearer than this are integrated in polar coordinates
  std::vector<Panel> panels_;
  Fast fast_;
};

}  // namespace rc::kernel::layer
