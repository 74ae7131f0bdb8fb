// Contact area, perimeter, and the area without what the grid adds to it.
#pragma once

#include <roughcontact/analysis.h>

#include "analysis/contact_map.h"

namespace rc {

rc_area measure_area(const ContactMap& map);

}  // namespace rc
