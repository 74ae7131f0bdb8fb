// Every exported function runs inside guard(): exceptions become a status and a message, and arithmetic is the default one.
#pragma once

#include <new>

#include "core/cancelled.h"
#include "core/default_arithmetic.h"
#include "core/error.h"

namespace rc {

template <class Body> rc_status guard(const char* where, const Body& body) {
  const DefaultArithmetic arithmetic;
  clear_message();
  // Allocates nothing, because an allocation may be what failed.
  const auto failed = [&](rc_status code, const char* what) {
    set_message(where, what);
    return code;
  };
  try {
    const rc_status status = body();
    if (status > 0) return failed(status, last_message()[0] != '\0' ? last_message() : rc_status_text(status));
    clear_message();
    return status;
  } catch (const Error& error) {
    return failed(error.code(), error.what());
  } catch (const std::bad_alloc&) {
    return failed(RC_ERR_MEMORY, "out of memory");
  } catch (const Cancelled&) {
    throw;  // the thread is being cancelled
  } catch (const std::exception& error) {
    return failed(RC_ERR_INTERNAL, error.what());
  } catch (...) {
    return failed(RC_ERR_INTERNAL, "an unknown exception");
  }
}

}  // namespace rc
