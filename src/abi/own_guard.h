// The guard of a library beside libroughcontact: exceptions become a status and a message of that library's own.
#pragma once

#include <cstdio>
#include <new>

#include "core/cancelled.h"
#include "core/default_arithmetic.h"
#include "core/error.h"

namespace rc {

// The calling thread's message in the library that Library, any type of its own, stands for. Fixed storage, so that it works when
// memory has run out.
template <class Library> inline thread_local char own_message[1024] = "";

template <class Library, class Body> rc_status own_guard(const char* where, const Body& body) {
  constexpr auto failed = [](const char* place, rc_status code, const char* what) {
    std::snprintf(own_message<Library>, sizeof own_message<Library>, "%s: %s", place, what);
    return code;
  };
  const DefaultArithmetic arithmetic;
  own_message<Library>[0] = '\0';
  try {
    body();
    return RC_OK;
  } catch (const Error& error) {
    return failed(where, error.code(), error.what());
  } catch (const std::bad_alloc&) {
    return failed(where, RC_ERR_MEMORY, "out of memory");
  } catch (const Cancelled&) {
    throw;  // the thread is being cancelled
  } catch (const std::exception& error) {
    return failed(where, RC_ERR_INTERNAL, error.what());
  }
}

}  // namespace rc
