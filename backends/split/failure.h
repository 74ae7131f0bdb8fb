// Failures inside the backend: thrown, and turned into a status and a message at the vtable.
#pragma once

#include <roughcontact/plugin.hpp>

namespace rc_split {

inline constexpr roughcontact::Component component{"split", "use a coarser grid, a smaller domain or fewer threads"};

template <class... Parts> [[noreturn]] void fail(rc_status code, const Parts&... parts) {
  roughcontact::fail(component, code, parts...);
}

}  // namespace rc_split
