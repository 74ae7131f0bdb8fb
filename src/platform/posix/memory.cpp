#include "platform/memory.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace rc_platform {

// The system is asked once: choosing components needs the number several times a step, and a small step would notice the calls.
double machine_bytes() {
  static const double bytes = [] {
    const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGE_SIZE);
    if (pages <= 0 || page <= 0) return std::numeric_limits<double>::infinity();
    return std::min(static_cast<double>(pages) * static_cast<double>(page), static_cast<double>(PTRDIFF_MAX));
  }();
  return bytes;
}

void prefer_large_pages(void* begin, std::size_t bytes) {
#ifdef MADV_HUGEPAGE  // C libraries before it have no name for it
  const long size = sysconf(_SC_PAGE_SIZE);
  if (size <= 0) return;
  const auto page = static_cast<std::uintptr_t>(size), address = reinterpret_cast<std::uintptr_t>(begin);
  const std::uintptr_t first = (address + page - 1) / page * page, end = (address + bytes) / page * page;
  if (first < end) madvise(static_cast<std::byte*>(begin) + (first - address), end - first, MADV_HUGEPAGE);
#else
  static_cast<void>(begin), static_cast<void>(bytes);
#endif
}

}  // namespace rc_platform
