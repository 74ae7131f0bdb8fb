// What a step asks for, and what its residuals are measured by.
#pragma once

#include "contact/workspace.h"

namespace rc {

// Throws Error(ARGUMENT, INFEASIBLE). surface: the step's.
void check_target(const rc_step& step, const Workspace& work, const StepSurface& surface);
bool nothing_touches(const rc_step& step, const Workspace& work);
// [length] of a prescribed approach, above the lowest gap.
double compression_of(const rc_step& step, const Workspace& work);
// What residuals of gaps are relative to, s [length].
double residual_scale(const rc_step& step, const Workspace& work, double compression);

}  // namespace rc
