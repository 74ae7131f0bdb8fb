// Many contacts on one system: threads share their histories.
#pragma once

#include <roughcontact/history.h>

#include <cstdint>
#include <string>

#include "registry/options_handle.h"

namespace rc {

struct BatchOutcome {
  rc_status status = RC_OK;  // of the first contact that failed, or else of the first that is not certified
  std::int64_t certified = 0;
  std::int64_t first = -1;  // the contact whose status it is
  std::string message;
};

// Writes the outputs of every contact. Throws Error if the batch itself is refused; nothing is written then.
BatchOutcome solve_batch(const rc_system& system, const rc_options& options, const rc_batch& batch);

}  // namespace rc
