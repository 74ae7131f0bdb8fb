#include "platform/memory.h"

#include <windows.h>

#include <limits>

namespace rc_platform {

double machine_bytes() {
  MEMORYSTATUSEX status{};
  status.dwLength = sizeof status;
  return GlobalMemoryStatusEx(&status) ? static_cast<double>(status.ullTotalPhys) : std::numeric_limits<double>::infinity();
}

// Large pages need a privilege here that users do not have.
void prefer_large_pages(void*, std::size_t) {}

}  // namespace rc_platform
