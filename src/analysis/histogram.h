// Distribution of pressure over the points in contact.
#pragma once

#include <roughcontact/analysis.h>

#include "analysis/contact_map.h"

namespace rc {

// Writes the arrays of `out` and its numbers. Throws Error(ARGUMENT) before anything is written.
void fill_histogram(const ContactMap& map, rc_histogram& out);

}  // namespace rc
