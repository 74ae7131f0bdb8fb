// The density of a rectangular cell's source along one axis, with unit mass, as a quadrature rule.
#pragma once

#include <array>

namespace rc::kernel {

// sum(weight[i] f(node[i])) is the mean of f: exact for polynomials of degree 22, and to round-off for functions whose
// singularities are no closer to the density's centre than twice the side of the cell.
struct Density {
  int size;
  std::array<double, 24> node, weight;
};

// Uniform over the side.
Density box(double side);

// The autocorrelation of the box, a triangle over twice the side: the distance between two uniformly distributed points.
Density tent(double side);

}  // namespace rc::kernel
