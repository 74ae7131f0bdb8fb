// Maps cut and turned over: points move, no height changes.
#pragma once

#include <cstdint>

#include "formats/surface.h"

namespace rc::formats {

// Lengths from the outer edge of the first cell, in the unit of the pitch.
struct Region {
  double x0, x1, y0, y1;
};

// Keeps the cells whose middles lie in the region. Throws an Error if there is none.
void crop(const Region& region, Surface& surface);

// Reverses the order of points along an axis.
void mirror(bool along_x, bool along_y, Surface& surface);

}  // namespace rc::formats
