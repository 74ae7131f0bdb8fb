// Grids that repeat along one axis only, for the kernels love and spectral.
//
// Let the grid repeat along x with the period L. Then q = F/L is the force of one period over its length. Far away q deflects the
// half-space as a line load does, by 2 q / (pi E*) ln(R/|y|). Only differences are determined, so the distance R at which the
// deflection is 0 can be chosen. R = nx hx + ny hy makes the coefficients of love positive, and H positive definite on the grid.
// A unit force at the origin and its images deflect, times pi E*,
//   2/L ln(R/|y|) + 4/L sum over k >= 1 of K0(q_k |y|) cos(q_k x),  q_k = 2 pi k / L.
#pragma once

#include <roughcontact/roughcontact.h>

#include "kernel/kernel.h"

namespace rc::kernel {

// Cells along the axis that repeats and across it.
struct Strip {
  std::int64_t n_along, n_across;
  double h_along, h_across;

  double period() const { return static_cast<double>(n_along) * h_along; }
  double width() const { return static_cast<double>(n_across) * h_across; }
  double datum() const { return period() + width(); }  // R
};

constexpr bool semi_periodic(std::int32_t boundary) {
  return boundary == RC_BOUNDARY_PERIODIC_X || boundary == RC_BOUNDARY_PERIODIC_Y;
}

// The strip of a grid with RC_BOUNDARY_PERIODIC_X or _Y.
Strip strip_of(const rc_system& grid);

// Coefficients of love or spectral at the offsets of a window, as window_coefficients() has for free boundaries. If a cell is
// longer across than the period, the time grows with their ratio.
void semi_periodic_coefficients(const Kernel&, const rc_system& grid, const Window&, double* out);

// With love and spectral x'Hx is at least this times x'Gx for every x, where G is the matrix of galerkin on the same strip.
//
// Only waves with q = 0 along the strip differ from those of the whole lattice. On a circle of twice the width W, ln(R/|y|) for
// |y| < W has the mean ln(R/W) + 1 > 0 and, at wave number j, the coefficient (1 + e_j)/j with |e_j| < 0.21/j, where the lattice
// has 1/j: no eigenvalue sinks by more than the share 0.42/n.
double share_of_galerkin(const Strip&);

// No eigenvalue of H on any set of the strip's cells is smaller [length].
double lowest_eigenvalue(const Kernel&, const Strip&);

// The stiffness over E* of a rigid punch that is `width` wide and as long as the period [length]. With galerkin no punch on cells
// inside it is stiffer.
double punch_stiffness(const Strip&, double width);

}  // namespace rc::kernel
