#include "cores.h"

#include <sched.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <thread>

#include "numbers.h"

namespace cli {

int usable_cores() {
  constexpr std::int64_t most = 1024;  // of option threads
  cpu_set_t set;
  std::int64_t cores = sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : std::thread::hardware_concurrency();
  if (const char* const limit = std::getenv("OMP_THREAD_LIMIT")) cores = std::min(cores, to_integer(limit).value_or(cores));
  return static_cast<int>(std::clamp<std::int64_t>(cores, 1, most));
}

}  // namespace cli
