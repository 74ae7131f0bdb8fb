// The power law in a spectrum, and where it begins and ends.
#pragma once

#include "spectrum.h"

namespace rc::surface {

// One bin of the radial spectrum on logarithmic axes.
struct Bin {
  double x = 0;         // ln q
  double y = 0;         // ln C, corrected for the mean of a logarithm
  double variance = 0;  // of y, for Gaussian amplitudes
  double share = 0;     // of the variance of the heights
};

// Bins of a quarter octave up to the Nyquist wave number. Bins without power, and modes of textures, are left out.
std::vector<Bin> logarithmic_bins(const Spectrum& spectrum);

// Sets everything but the peaks.
void find_power_law(const Spectrum& spectrum, rc_surface_power_law& law);

}  // namespace rc::surface
