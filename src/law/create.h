// Makes a law: nodes where the bounds between those that there are leave too much open.
#pragma once

#include <memory>

#include "law/law.h"

namespace rc {

// Throws Error.
std::unique_ptr<rc_law> create_law(const rc_system& system, const rc_options* options, const rc_law_spec& spec);

}  // namespace rc
