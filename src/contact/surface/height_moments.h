// The mean height of a surface's included points above the lowest, and their variance.
#pragma once

namespace rc {

class StepSurface;

struct HeightMoments {
  double mean = 0;    // [length] accurate to 1e-13 of the range
  double square = 0;  // [length^2] sum of the squared differences to the mean
};

// A pass over the surface.
HeightMoments moments_of(const StepSurface& surface);

}  // namespace rc
