// The points of a surface whose gap is below a limit.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "contact/surface/extent.h"
#include "contact/surface/step_surface.h"
#include "operator/operator.h"

namespace rc {

inline constexpr std::int64_t any_box = std::numeric_limits<std::int64_t>::max();

// Included points with gap < limit; none if their bounding box has more than most_box points.
TrialSet points_below(double limit, const StepSurface& surface, std::int64_t most_box = any_box);
TrialSet included_points(const StepSurface& surface);
Extent extent_below(double limit, const StepSurface& surface);  // of all processes

}  // namespace rc
