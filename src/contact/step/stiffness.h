// The stiffness dW/dd of a contact.
#pragma once

#include "contact/answer.h"
#include "contact/workspace.h"

namespace rc {

// [force/length] hx hy 1' H_CC^-1 1 on the points C with 0 < p < hardness; NaN where a stop came before it was found.
double stiffness(Workspace& work, const Answer& answer);

}  // namespace rc
