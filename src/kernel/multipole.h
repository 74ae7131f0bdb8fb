// The mean of 1/r over a symmetric density, seen from far away.
#pragma once

#include <array>

#include "kernel/density.h"
#include "kernel/kernels.h"

namespace rc::kernel {

// Laplace's expansion 1/|x - s| = sum_n |s|^n / |x|^(n+1) P_n(cos gamma), averaged over s. With
// P_n(cos gamma) = sum_j a_j a_(n-j) cos((n - 2j) gamma), a_j = (2j)! / (4^j j!^2), and a density symmetric in both axes,
// only the even n = 2k and the cosines of even multiples of the angle phi of x remain:
//   mean(1/r) = 1/|x| sum_k |x|^(-2k) sum_(l <= k) c_kl T_l(cos 2 phi).
class Multipole {
 public:
  Multipole(const Density& along_x, const Density& along_y);

  // Whether the expansion has converged to round-off at a distance squared.
  bool reaches(double square) const { return square >= reach_.back(); }
  // At points with distance^2 = square and cos 2 phi = t; without meaning where the expansion does not reach. `nearest` is no
  // larger than any of the squares and decides how many terms are summed.
  void mean_inverse_distance(const Run& square, const Run& t, double nearest, Run& out) const;

 private:
  static constexpr int order = 10;

  std::array<std::array<double, order + 1>, order + 1> power_{};  // the polynomials in t, by powers of t
  std::array<double, order + 1> reach_{};                         // |x|^2 from which the terms up to k suffice; decreasing
};

}  // namespace rc::kernel
