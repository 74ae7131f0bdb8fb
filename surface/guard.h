// Every exported function runs inside guard(): exceptions become a status and a message of this library's own.
#pragma once

#include "abi/own_guard.h"

namespace rc::surface {

struct Library;

inline const char* last_message() { return own_message<Library>; }

template <class Body> rc_status guard(const char* where, const Body& body) { return own_guard<Library>(where, body); }

}  // namespace rc::surface
