// The flag of rc_flow_stop_when.
#pragma once

#include "core/error.h"
#include "core/host_call.h"

namespace rc::flow {

struct Library;

// Called every few milliseconds of work.
inline void stop_if_asked() {
  if (stop_asked<Library>()) fail(RC_STOP_CANCELLED, "the flag of rc_flow_stop_when is set");
}

}  // namespace rc::flow
