// Single heights far from those around them.
#pragma once

#include <cstdint>

#include "formats/surface.h"

namespace rc::formats {

struct Spikes {
  std::int64_t count = 0;
  double largest = 0;  // distance from the median
};

// Makes spikes missing. r: the height less the median of the present heights of the 5 x 5 points around; edges are reflected
// (... 1 0 | 0 1 2 ...). A spike has |r| > factor * median |r|; there is none if that median is 0.
Spikes remove_spikes(double factor, Surface& surface);

}  // namespace rc::formats
