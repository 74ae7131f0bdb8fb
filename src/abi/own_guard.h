// The guard of the other libraries: exceptions become a status and the message of that library.
#pragma once

#include <cstdio>

#include "core/caught.h"
#include "core/default_arithmetic.h"
#include "core/host_call.h"

namespace rc {

// The calling thread's message in the library that Library, any type of its own, stands for. Fixed storage, so that it works when
// memory has run out.
template <class Library> inline thread_local char own_message[1024] = "";

template <class Library, class Body> rc_status own_guard(const char* where, const Body& body) {
  const HostsCall call;
  const DefaultArithmetic arithmetic;
  own_message<Library>[0] = '\0';
  return caught(
      [&]() -> rc_status {
        body();
        return RC_OK;
      },
      [&](rc_status status, const char* what) {
        std::snprintf(own_message<Library>, sizeof own_message<Library>, "%s: %s", where, what);
        return status;
      });
}

}  // namespace rc
