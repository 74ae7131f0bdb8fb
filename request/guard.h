// Exceptions become the status and message of this library.
#pragma once

#include "abi/own_guard.h"
#include "core/error.h"
#include "request/names.h"

namespace rc::request {

struct Library;

// Messages are for users, who know no functions.
template <class Body> rc_status guard(const Body& body) {
  return own_guard<Library>("", [&] {
    try {
      body();
    } catch (const Error& error) {
      fail(RC_ERR_ARGUMENT, error.what());
    }
  });
}

}  // namespace rc::request
