// Solves of dilute contacts: by default options, and by backend fft and haar-cg over the whole grid.
#pragma once

#include "dilute.h"

namespace bench {

Json dilute_solves(const DiluteRequest& request);

}  // namespace bench
