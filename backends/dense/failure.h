// Failures inside the backend: thrown, and turned into a status and a message at the vtable.
#pragma once

#include <roughcontact/plugin.hpp>

namespace rc_dense {

inline constexpr roughcontact::Component component{"dense", "use a matrix-free backend or lower dense.memory_limit"};

template <class... Parts> [[noreturn]] void fail(rc_status code, const Parts&... parts) {
  roughcontact::fail(component, code, parts...);
}

}  // namespace rc_dense
