// rc_gap_from_heights
#include <cmath>
#include <limits>

#include "abi/guard.h"

extern "C" rc_status rc_gap_from_heights(int64_t n, const double* heights, const uint8_t* mask, double* undeformed_gap) {
  using namespace rc;
  return guard("rc_gap_from_heights", [&] {
    if (n < 0) fail(RC_ERR_ARGUMENT, "n = ", n, " must be >= 0");
    if (n > 0 && (!heights || !undeformed_gap)) fail(RC_ERR_ARGUMENT, heights ? "undeformed_gap" : "heights", " is null");
    double highest = -std::numeric_limits<double>::infinity();
    for (std::int64_t i = 0; i < n; ++i)
      if (!mask || mask[i] != 0) highest = std::fmax(highest, heights[i]);  // passes over NaN
    if (highest == -std::numeric_limits<double>::infinity()) highest = 0;   // no point is there
    for (std::int64_t i = 0; i < n; ++i) undeformed_gap[i] = highest - heights[i];
    return RC_OK;
  });
}
