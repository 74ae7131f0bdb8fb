#include "platform/terminal.h"

#include <sched.h>

#include <thread>

int rc_platform::usable_cores() {
  cpu_set_t set;
  return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : static_cast<int>(std::thread::hardware_concurrency());
}
