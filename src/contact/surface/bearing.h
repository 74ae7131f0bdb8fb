// The height at which a bed of springs on a surface carries a load.
#pragma once

namespace rc {

class StepSurface;

// The height t above the lowest gap at which sum(max(t - (gap - lowest), 0)) / sqrt(points with gap - lowest < t) = target, to
// about two percent from above.
double bearing_height(double target, const StepSurface& surface);

}  // namespace rc
