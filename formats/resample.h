// Heights between the points of a map.
#pragma once

#include <cstdint>
#include <vector>

#include "formats/surface.h"

namespace rc::formats {

enum class Interpolation { linear, cubic };

// Points of another grid along one axis of a map: i lies at first + i * step, in pitches of the map from its first point.
struct Samples {
  std::int64_t count;
  double first, step;
};

// Heights at these points; missing where the map has none, or a missing one takes part. cubic: convolution with a = -1/2
// (Keys 1981, equation 15), with the points beyond an edge that continue the parabola there (his equation 19). Exact at points
// of the map. A map that repeats has points everywhere.
std::vector<double> heights_at(const Surface& surface, bool repeats, Interpolation method, const Samples& x, const Samples& y);

}  // namespace rc::formats
