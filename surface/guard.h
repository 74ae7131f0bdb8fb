// Every exported function runs inside guard(): exceptions become a status and a message of this library's own.
#pragma once

#include <cxxabi.h>

#include <new>

#include "core/error.h"

namespace rc::surface {

const char* last_message();
void set_message(const char* where, const char* text);
void clear_message();

template <class Body> rc_status guard(const char* where, const Body& body) {
  clear_message();
  try {
    body();
    return RC_OK;
  } catch (const Error& error) {
    set_message(where, error.what());
    return error.code();
  } catch (const std::bad_alloc&) {
    set_message(where, "out of memory");
    return RC_ERR_MEMORY;
  } catch (const abi::__forced_unwind&) {
    throw;  // the thread is being cancelled
  } catch (const std::exception& error) {
    set_message(where, error.what());
    return RC_ERR_INTERNAL;
  }
}

}  // namespace rc::surface
