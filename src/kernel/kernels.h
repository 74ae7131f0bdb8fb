// The kernels behind the registry in kernel.cpp: one table-filling function each.
#pragma once

#include <cstdint>

#include "kernel/kernel.h"

namespace rc::kernel {

// The offsets (first_x + ix, first_y + iy), 0 <= ix < mx, 0 <= iy < my, of a table out[iy*mx + ix].
struct Window {
  std::int64_t first_x, first_y, mx, my;
};

// coefficients() of any window; constructing a kernel's expansion costs some microseconds.
void window_coefficients(const Kernel&, double hx, double hy, const Window&, double* out);

void love(double hx, double hy, const Window&, double* out);
void galerkin(double hx, double hy, const Window&, double* out);

// Square cells: hy is hx.
void disc(double hx, double hy, const Window&, double* out);
void punch(double hx, double hy, const Window&, double* out);
void eq9(double hx, double hy, const Window&, double* out);

// Calls value(x, y) with every offset, in cells.
template <class Value> void fill(const Window& window, double* out, Value value) {
  for (std::int64_t iy = 0; iy < window.my; ++iy)
    for (std::int64_t ix = 0; ix < window.mx; ++ix)
      *out++ = value(static_cast<double>(window.first_x + ix), static_cast<double>(window.first_y + iy));
}

}  // namespace rc::kernel
