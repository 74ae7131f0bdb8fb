#include "cores.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "numbers.h"
#include "platform/terminal.h"

namespace cli {

int usable_cores() {
  constexpr std::int64_t most = 1024;  // of option threads
  std::int64_t cores = rc_platform::usable_cores();
  if (const char* const limit = std::getenv("OMP_THREAD_LIMIT")) cores = std::min(cores, to_integer(limit).value_or(cores));
  return static_cast<int>(std::clamp<std::int64_t>(cores, 1, most));
}

}  // namespace cli
