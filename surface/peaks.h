// Periodic textures: single waves that stand out of the spectrum.
#pragma once

#include "spectrum.h"

namespace rc::surface {

// Sets peaks, peak_qx, peak_qy and peak_share, and marks their modes in the spectrum.
void find_peaks(Spectrum& spectrum, rc_surface_power_law& law);

}  // namespace rc::surface
