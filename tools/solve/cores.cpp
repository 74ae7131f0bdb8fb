#include "solve/cores.h"

#include <algorithm>
#include <cstdlib>

#include "numbers.h"
#include "platform/terminal.h"

namespace cli {

int default_threads(std::int64_t points) {
  constexpr std::int64_t most = 1024, points_each = 16384;  // of option threads; fewer points gain nothing
  std::int64_t cores = std::min<std::int64_t>(rc_platform::usable_cores(), most);
  for (const char* const name : {"OMP_THREAD_LIMIT", "OMP_NUM_THREADS"}) {
    const char* const text = std::getenv(name);
    const std::int64_t limit = text ? to_integer(text).value_or(0) : 0;
    if (limit > 0) cores = std::min(cores, limit);
  }
  return static_cast<int>(std::max<std::int64_t>(1, std::min(cores, points / points_each)));
}

}  // namespace cli
