// Replaces the program's operator new, so that one allocation can be made to fail. Link it into the test program: the shared
// library and plugins then use it as well. Absurd sizes fail without asking the system, because sanitizers would print.
#pragma once

#include <cstddef>
#include <cstdint>

namespace support {

// The `countdown`-th allocation of this thread from now on fails, and with `forever` all that follow; 0: none.
void fail_allocation(std::int64_t countdown, bool forever = false);
// Bytes of the largest one of this thread since then.
std::size_t largest_allocation();
// Whether that allocation was reached and failed.
bool allocation_failed();

}  // namespace support
