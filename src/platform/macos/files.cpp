#include <fcntl.h>
#include <unistd.h>

#include "platform/posix/system.h"

// fsync alone leaves the data in the disk's own memory; file systems that cannot do more say so.
bool rc_platform::reach_disk(int descriptor) { return fcntl(descriptor, F_FULLFSYNC) == 0 || fsync(descriptor) == 0; }
