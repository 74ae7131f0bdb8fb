// A contact law: pressure against overclosure, area and conductance against pressure with their bounds, and how wide those of the
// pressure are.
#pragma once

#include <cstdio>

#include "law/patch_law.h"
#include "pictures/gnuplot.h"

namespace cli {

Gnuplot draw_law(const PatchLaw& law, std::FILE* file);

}  // namespace cli
