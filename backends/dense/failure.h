#pragma once

#include "common/failure.h"

RC_FAILURES_OF(rc_dense, "dense", "use a matrix-free backend or lower dense.memory_limit")
