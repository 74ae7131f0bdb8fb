// Numbers from text, as the readers of files take them.
#pragma once

#include "formats/numbers.h"

namespace cli {

using namespace rc::formats;

}  // namespace cli
