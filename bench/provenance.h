// What a reader needs to judge or repeat a run.
#pragma once

#include <cstdint>
#include <string>

#include "child.h"

namespace bench {

// A hash of the library in use and of the plugins beside it: what was measured.
std::string library_hash();

Json provenance(std::int64_t threads);

}  // namespace bench
