// Points that were not measured: NaN in the heights.
#pragma once

#include <cstdint>

#include "formats/surface.h"

namespace rc::formats {

std::int64_t count_missing(const Surface& surface);

// Harmonic interpolation: every missing point becomes the mean of its neighbours, weighted by distance^-2, like a soap film over
// a hole. Filled heights lie between those around the hole, so no summit is invented. The pitch must be known.
void fill_missing(Surface& surface);

}  // namespace rc::formats
