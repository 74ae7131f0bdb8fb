#include <unistd.h>

#include "platform/posix/system.h"

bool rc_platform::reach_disk(int descriptor) { return fsync(descriptor) == 0; }
