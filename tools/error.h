// A failure that the user can act on; the command prints it as one line and exits with code 1.
#pragma once

#include "formats/error.h"

namespace cli {

using namespace rc::formats;

}  // namespace cli
