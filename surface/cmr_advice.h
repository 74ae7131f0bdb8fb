// Whether the contacts on a coarse grid show where those on the fine grid are.
#pragma once

#include "spectrum.h"

namespace rc::surface {

// How many halvings leave 4 points along the longer side: what levels = 0 stands for.
std::int32_t most_levels(const Heights& heights);

rc_surface_cmr cmr_advice(const Heights& heights, const rc_surface_power_law& law, std::int32_t levels, double approach);

}  // namespace rc::surface
