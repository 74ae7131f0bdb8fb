// Failures inside a backend: thrown, and turned into a status and a message at the vtable.
#pragma once

#include <roughcontact/plugin.hpp>

// Gives the namespace of a backend `component`, whose messages they are, and fail(code, parts...).
#define RC_FAILURES_OF(space, name, advice)                                                 \
  namespace space {                                                                         \
  inline constexpr roughcontact::Component component{name, advice};                         \
  template <class... Parts> [[noreturn]] void fail(rc_status code, const Parts&... parts) { \
    roughcontact::fail(component, code, parts...);                                          \
  }                                                                                         \
  }
