// The radial power spectral density with the power law fitted to it.
#pragma once

#include <cstdio>

#include "pictures/gnuplot.h"
#include "surface/analysis.h"

namespace cli {

Gnuplot draw_spectrum(const Analysis& analysis, std::FILE* file);

}  // namespace cli
