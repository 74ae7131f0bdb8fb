// A loading history on one contact, step after step.
#pragma once

#include <cstdint>

#include "contact/calls/contact.h"

namespace rc {

// `completed` counts the steps whose outputs are written. Throws Error with the step's number.
rc_status solve_history(Contact& contact, const rc_history& history, std::int64_t& completed);

}  // namespace rc
