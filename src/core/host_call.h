// The two ways in which the host ends a call: it sets a flag, or it cancels the thread that made the call.
#pragma once

#include <cstdint>

#include "platform/threads.h"

namespace rc {

using rc_platform::HostsCall;
using rc_platform::HostsTurn;

// The flag that ends the calling thread's calls of the library that Library, any type of its own, stands for; null: none.
template <class Library> inline thread_local const std::int32_t* stop_flag = nullptr;

// Asked where nothing is locked and a call may end, some ten times a second at least. A thread that is cancelled ends here.
template <class Library> bool stop_asked() {
  rc_platform::end_if_cancelled();
  const std::int32_t* const flag = stop_flag<Library>;
  return flag && __atomic_load_n(flag, __ATOMIC_RELAXED) != 0;
}

struct ContactLibrary;

}  // namespace rc
