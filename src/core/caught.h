// Turns exceptions into a status and a message.
#pragma once

#include <new>

#include "core/cancelled.h"
#include "core/error.h"

namespace rc {

// Runs action(), which returns a status. If it throws, status and message are written to `failed`, and the status is returned.
// Allocates nothing, because an allocation may be what failed.
template <class Action, class Failed> rc_status caught(const Action& action, const Failed& failed) {
  try {
    return action();
  } catch (const Error& error) {
    return failed(error.code(), error.what());
  } catch (const OutOfMemory& error) {
    return failed(RC_ERR_MEMORY, error.what());
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

// The same with the message as the calling thread's.
template <class Action> rc_status caught(const Action& action) {
  return caught(action, [](rc_status status, const char* what) {
    set_message(what);
    return status;
  });
}

}  // namespace rc
