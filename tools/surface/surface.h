// Surfaces as the readers of files hand them over.
#pragma once

#include "formats/surface.h"

namespace cli {

using namespace rc::formats;

}  // namespace cli
