// The kernels of the homogeneous half-space; layer/ has one of another body.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/kernel.h"

namespace rc::kernel {

void love(double hx, double hy, const Window&, double* out);
void galerkin(double hx, double hy, const Window&, double* out);

// Square cells: hy is hx.
void disc(double hx, double hy, const Window&, double* out);
void punch(double hx, double hy, const Window&, double* out);
void eq9(double hx, double hy, const Window&, double* out);

// Sorted by name.
inline constexpr std::array<Kernel, 6> kernels{{
    {"disc", "uniform pressure on the inscribed disc, centre deflection; square cells, first order", Boundary::free, true, false,
     disc},
    {"eq9",
     "punch with the self term printed in Bemporad & Paggi (2015), eq. (9), 36 % too small: only to reproduce their results",
     Boundary::free, true, false, eq9},
    {"galerkin", "uniform pressure on the cell, mean deflection of the receiving cell; second order", Boundary::free, false,
     false, galerkin},
    {"love", "uniform pressure on the cell, centre deflection (Love 1929); second order", Boundary::free, false, true, love},
    {"punch", "rigid circular punch inscribed in the cell; square cells, first order", Boundary::free, true, false, punch},
    {"spectral", "exact for every wave that the periodic grid resolves: 2/|q|, mean 0", Boundary::periodic, false, true, nullptr},
}};

// cos(2 pi i/n), i = 0 .. n - 1
std::vector<double> cosines_of_a_turn(std::int64_t n);

// Coefficients at neighbouring offsets of a row, computed side by side so that the compiler can use vector instructions. Runs
// begin at multiples of their length whatever the window, so that a coefficient does not depend on the window either.
inline constexpr int run_length = 32;
using Run = std::array<double, run_length>;

// Calls run(x, y, values) for the runs that overlap the window: offsets (x, y) .. (x + run_length - 1, y), in cells.
template <class Compute> void fill(const Window& window, double* out, const Compute& run) {
  const std::int64_t end_x = window.first_x + window.mx;
  Run values;
  for (std::int64_t iy = window.first_y; iy < window.first_y + window.my; ++iy)
    for (std::int64_t x = window.first_x / run_length * run_length; x < end_x; x += run_length) {
      run(static_cast<double>(x), static_cast<double>(iy), values);
      for (std::int64_t ix = std::max(x, window.first_x); ix < std::min(x + run_length, end_x); ++ix)
        *out++ = values[static_cast<std::size_t>(ix - x)];
    }
}

}  // namespace rc::kernel
