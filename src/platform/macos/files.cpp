#include <fcntl.h>
#include <signal.h>  // NOLINT: sigwait is of POSIX
#include <unistd.h>

#include "platform/posix/system.h"

namespace rc_platform {

// fsync alone leaves the data in the disk's own memory; file systems that cannot do more say so.
bool reach_disk(int descriptor) { return fcntl(descriptor, F_FULLFSYNC) == 0 || fsync(descriptor) == 0; }

// This system has no sigtimedwait.
void take_pending(int signal) {
  sigset_t set, pending;
  sigemptyset(&set);
  sigaddset(&set, signal);
  int taken = 0;
  if (sigpending(&pending) == 0 && sigismember(&pending, signal) == 1) sigwait(&set, &taken);
}

}  // namespace rc_platform
