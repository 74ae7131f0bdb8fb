// The rms slope of a surface.
#pragma once

#include "contact/surface/step_surface.h"

namespace rc {

// The rms of the height differences between neighbours along x and y over the pitch, times sqrt(2); 0 without neighbours.
// Excluded points are left out. By rows all processes call it together.
double rms_slope(const StepSurface& surface, double hx, double hy);

}  // namespace rc
