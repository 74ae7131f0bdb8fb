// Failures inside the backend: thrown, and turned into a status and a message at the vtable.
#pragma once

#include <roughcontact/plugin.hpp>

namespace rc_fft {

inline constexpr roughcontact::Component component{"fft", "use a coarser grid or a smaller domain"};

template <class... Parts> [[noreturn]] void fail(rc_status code, const Parts&... parts) {
  roughcontact::fail(component, code, parts...);
}

}  // namespace rc_fft
