// Contact area, perimeter, and the area corrected for what the grid adds.
#pragma once

#include <roughcontact/analysis.h>

#include "analysis/contact_map.h"

namespace rc {

rc_area measure_area(const ContactMap& map);

}  // namespace rc
