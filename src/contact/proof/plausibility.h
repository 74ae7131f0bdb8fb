// Remarks on correct results that hint at a blunder in the units or the heights. They refuse nothing.
#pragma once

#include <string>
#include <vector>

#include "contact/step_surface.h"
#include "contact/system.h"

namespace rc {

// The share of the heights' variance that a plane explains, 0 .. 1. It looks at no more than 32 x 32 evenly spread points; 0 if
// there are fewer than 16.
double plane_share(const StepSurface& surface, std::int64_t nx, std::int64_t ny);

// Remarks on a half-space in contact, the gravest first. tilt: plane_share.
std::vector<std::string> doubts(const System& system, const rc_result& result, double compression, double tilt);

}  // namespace rc
