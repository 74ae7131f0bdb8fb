#pragma once

#include "common/failure.h"

RC_FAILURES_OF(rc_fft, "fft", "use a coarser grid or a smaller domain")
