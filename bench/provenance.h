// What a reader needs to judge or repeat a run.
#pragma once

#include "child.h"

namespace bench {

Json provenance(std::int64_t threads);

}  // namespace bench
