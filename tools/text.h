// Text for people.
#pragma once

#include <string_view>

#include "formats/wording.h"

namespace cli {

using namespace rc::formats;

// Writes "roughcontact: text" as exactly one line to standard error. Allocates nothing.
void report(std::string_view text);

}  // namespace cli
