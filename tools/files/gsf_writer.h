// Gwyddion Simple Field, lengths in metres; heights become float32.
#pragma once

#include <cstdio>

#include "surface/surface.h"

namespace cli {

void write_gsf(std::FILE* file, const Surface& surface);

}  // namespace cli
