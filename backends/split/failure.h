#pragma once

#include "common/failure.h"

RC_FAILURES_OF(rc_split, "split", "use a coarser grid, a smaller domain or fewer threads")
