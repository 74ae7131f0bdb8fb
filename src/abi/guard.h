// Every exported function runs inside guard(): exceptions become a status and a message, arithmetic is the default one, and the
// thread is not cancelled where something is locked.
#pragma once

#include "core/caught.h"
#include "core/default_arithmetic.h"
#include "core/host_call.h"

namespace rc {

template <class Body> rc_status guard(const char* where, const Body& body) {
  const HostsCall call;
  const DefaultArithmetic arithmetic;
  clear_message();
  const auto failed = [&](rc_status code, const char* what) {
    set_message(where, what);
    return code;
  };
  return caught(
      [&] {
        const rc_status status = body();
        if (status > 0) return failed(status, last_message()[0] != '\0' ? last_message() : rc_status_text(status));
        clear_message();
        return status;
      },
      failed);
}

}  // namespace rc
