// Failures inside the backend: thrown, and turned into a status and a message at the vtable.
#pragma once

#include <roughcontact/plugin.hpp>

namespace rc_cholmod {

inline constexpr roughcontact::Component component{"cholmod", "use a matrix-free backend or set cholmod.near_field"};

template <class... Parts> [[noreturn]] void fail(rc_status code, const Parts&... parts) {
  roughcontact::fail(component, code, parts...);
}

// Throws if the caller has asked to stop.
inline void check_for_stop(const rc_operator_spec& spec) {
  if (spec.struct_size >= sizeof(rc_operator_spec) && spec.poll) roughcontact::check(spec.poll(&spec));
}

}  // namespace rc_cholmod
