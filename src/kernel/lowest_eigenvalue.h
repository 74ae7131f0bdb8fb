// Bounds of the spectrum of influence matrices, for any set of points.
#pragma once

#include <cstdint>

#include "kernel/kernel.h"

namespace rc::kernel {

// Free kernels: no eigenvalue of H on any finite set of cells of the lattice is smaller [length]. 0: none is known.
double lowest_eigenvalue(const Kernel&, double hx, double hy);

// Free kernels: c with x'Hx >= c x'Gx for all x, where G is the matrix of the kernel galerkin. 0: none is known.
double share_of_galerkin(const Kernel&);

// Periodic kernels: the smallest eigenvalue but the mean's [length]; 0 on a grid of one point.
double lowest_wave_eigenvalue(const Kernel&, double hx, double hy, std::int64_t nx, std::int64_t ny);

}  // namespace rc::kernel
