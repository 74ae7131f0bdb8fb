// Connected parts of the contact.
#pragma once

#include <roughcontact/analysis.h>

#include "analysis/contact_map.h"

namespace rc {

// Writes label and the arrays of `out`, and returns the number of patches. Throws Error(ARGUMENT) before anything is written.
std::int64_t find_patches(const ContactMap& map, const rc_patches& out);

}  // namespace rc
