// Tables of a law for programs without user routines.
#pragma once

#include <string>

#include "law/law.h"

namespace rc {

// The text of the file; fills in spec.error. Throws Error(ARGUMENT).
std::string cards_of(const Law& law, rc_law_export_spec& spec);

}  // namespace rc
