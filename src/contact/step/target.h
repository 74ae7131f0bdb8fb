// A step's target, and the scale of its residuals.
#pragma once

#include "contact/workspace.h"

namespace rc {

// Throws Error(ARGUMENT, INFEASIBLE). surface: the step's.
void check_target(const rc_step& step, const Workspace& work, const StepSurface& surface);
bool nothing_touches(const rc_step& step, const Workspace& work);
// [length] The prescribed approach less the lowest gap.
double compression_of(const rc_step& step, const Workspace& work);
// The scale s [length] that residuals of gaps are relative to.
double residual_scale(const rc_step& step, const Workspace& work, double compression);

}  // namespace rc
