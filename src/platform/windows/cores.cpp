#include "platform/cores.h"

#include <windows.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <thread>

namespace rc_platform {

std::int64_t allowed_cores() {
  DWORD_PTR process = 0, machine = 0;
  if (!GetProcessAffinityMask(GetCurrentProcess(), &process, &machine) || process == 0)
    return std::max<std::int64_t>(1, std::thread::hardware_concurrency());
  return std::popcount(static_cast<std::uint64_t>(process));
}

std::int64_t granted_cores(const std::string&) { return 0; }

}  // namespace rc_platform
