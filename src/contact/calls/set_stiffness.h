// The stiffness of a rigid flat punch on given points.
#pragma once

#include "contact/slopes/stiffness.h"

namespace rc {

// dW/dd of a rigid flat punch on exactly the points where the mask [nx*ny] is not 0 (null: all). RC_STOP_STALLED: round-off may
// keep a larger error than the tolerance, which the interval counts. RC_STOP_TIME: not found.
rc_status set_stiffness(const rc_system& given, const std::uint8_t* mask, const rc_options& options,
                        StiffnessInterval& stiffness);

}  // namespace rc
