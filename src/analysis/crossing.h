// Whether the contact, or the gap that it leaves open, reaches across the surface.
#pragma once

#include <roughcontact/analysis.h>

#include "analysis/contact_map.h"

namespace rc {

rc_crossing find_crossing(const ContactMap& map);

}  // namespace rc
