// The two ways in which the host ends a call: it sets a flag, or it cancels the thread that made the call.
#pragma once

#include <cstdint>
#include <utility>

#include "platform/threads.h"

namespace rc {

using rc_platform::HostsCall;
using rc_platform::HostsTurn;

// The flag that ends the calling thread's calls of the library that Library, any type of its own, stands for; null: none.
template <class Library> inline thread_local const std::int32_t* stop_flag = nullptr;

// Whether the flag is set. Called where no lock is held and the call may end, at least ten times a second. A cancelled thread
// ends here.
template <class Library> bool stop_asked() {
  rc_platform::end_if_cancelled();
  const std::int32_t* const flag = stop_flag<Library>;
  return flag && __atomic_load_n(flag, __ATOMIC_RELAXED) != 0;
}

struct ContactLibrary;

// While it lives, the flag ends nothing: for work that several ranks repeat, each by itself, and must all complete.
class FlagIgnored {
 public:
  FlagIgnored() : before_(std::exchange(stop_flag<ContactLibrary>, nullptr)) {}
  ~FlagIgnored() { stop_flag<ContactLibrary> = before_; }
  FlagIgnored(const FlagIgnored&) = delete;
  FlagIgnored& operator=(const FlagIgnored&) = delete;

 private:
  const std::int32_t* const before_;
};

}  // namespace rc
