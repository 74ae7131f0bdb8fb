// Makes one allocation of the program fail.
#pragma once

#include <cstdint>

namespace seam {

// The `countdown`-th operator new from now on fails, in any thread; 0: none does.
void fail_allocation(std::int64_t countdown);
// Whether it has failed by now.
bool allocation_failed();

}  // namespace seam
