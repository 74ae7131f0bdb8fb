// Common parts of the kernels of rectangular cells: the coefficient is (hx hy / pi) times the mean of 1/r over a density, and the
// formula that keeps full accuracy depends on the distance.
#pragma once

#include "kernel/density.h"
#include "kernel/kernels.h"

namespace rc::kernel {

// Lengths in units of the cell's long side: x along it, y along the other, whose length is `side` <= 1.
struct Rectangle {
  Density (*density)(double side);                    // along each axis
  double (*on_line)(double x, double y);              // mean of 1/r over the density along x only, y > 0
  double (*closed)(double x, double y, double side);  // mean of 1/r over both, used for y <= side
};

void fill_rectangle(const Rectangle&, double hx, double hy, const Window&, double* out);

}  // namespace rc::kernel
