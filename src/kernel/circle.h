// What the kernels of circles inscribed in square cells share: the coefficient depends on the distance only.
#pragma once

#include <cstdint>

namespace rc::kernel {

// self and elsewhere(the distance squared, in cells) are in units of the cell's side.
template <class Elsewhere>
void fill_circle(double side, double self, Elsewhere elsewhere, std::int64_t mx, std::int64_t my, double* out) {
  double* value = out;
  for (std::int64_t iy = 0; iy < my; ++iy)
    for (std::int64_t ix = 0; ix < mx; ++ix) *value++ = side * elsewhere(static_cast<double>(ix * ix + iy * iy));
  if (mx > 0 && my > 0) out[0] = side * self;
}

}  // namespace rc::kernel
