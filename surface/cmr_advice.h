// Whether the contacts of a coarse grid tell where those of the fine one are.
#pragma once

#include "spectrum.h"

namespace rc::surface {

// levels = 0: as many halvings as leave 4 points along the longer side.
std::int32_t most_levels(const Heights& heights);

rc_surface_cmr cmr_advice(const Heights& heights, const rc_surface_power_law& law, std::int32_t levels, double approach);

}  // namespace rc::surface
