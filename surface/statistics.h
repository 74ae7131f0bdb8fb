#pragma once

#include "heights.h"

namespace rc::surface {

rc_surface_statistics statistics(const Heights& heights);

}  // namespace rc::surface
