// The pressure at which a seal closes, between one at which it is proven to be open and one at which it is proven to be closed.
#pragma once

#include <roughcontact/flow.h>

#include "contact_gap.h"

namespace rc::flow {

// sides: RC_FLOW_*. The members of the answer but its size.
rc_flow_closing closing_pressure(const rc_system& system, const rc_options* options, const rc_step& step,
                                 const rc_flow_spec& spec);

}  // namespace rc::flow
