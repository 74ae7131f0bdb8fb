#pragma once

#include "common/failure.h"

RC_FAILURES_OF(rc_cholmod, "cholmod", "use a matrix-free backend or set cholmod.near_field")

namespace rc_cholmod {

// Throws if the caller has asked to stop.
inline void check_for_stop(const rc_operator_spec& spec) {
  if (spec.poll) roughcontact::check(spec.poll(&spec));
}

}  // namespace rc_cholmod
