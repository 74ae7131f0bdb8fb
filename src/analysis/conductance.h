// Conductance of a contact from its stiffness.
#pragma once

#include <roughcontact/roughcontact.h>

namespace rc {

// 2 / (E* (rho1 + rho2)) (Barber 2003). Throws Error(ARGUMENT), also for an answer whose half-space is not homogeneous.
double conductance_per_stiffness(const rc_system& system, const rc_result& answer, double rho1, double rho2);

}  // namespace rc
