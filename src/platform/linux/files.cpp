#include <signal.h>  // NOLINT: sigtimedwait is of POSIX
#include <unistd.h>

#include "platform/posix/system.h"

namespace rc_platform {

bool reach_disk(int descriptor) { return fsync(descriptor) == 0; }

void take_pending(int signal) {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, signal);
  const timespec at_once{};
  sigtimedwait(&set, nullptr, &at_once);
}

}  // namespace rc_platform
