// Whether the contact, or the gap that it leaves open, reaches across the grid.
#pragma once

#include <roughcontact/analysis.h>

#include "analysis/contact_map.h"

namespace rc {

// The axes along which the points with `contact`, or those without it, reach across: a sum of RC_CROSSES_*. The sides at the ends
// of the axis stay apart; those beside it are joined if the grid repeats there.
std::int32_t crossed_axes(const ContactMap& map, bool contact);

}  // namespace rc
