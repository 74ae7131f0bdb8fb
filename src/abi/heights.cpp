// rc_gap_from_heights
#include <cmath>
#include <limits>

#include "abi/arrays.h"
#include "abi/guard.h"

extern "C" rc_status rc_gap_from_heights(int64_t n, rc_const_array heights, rc_const_array mask, rc_array undeformed_gap) {
  using namespace rc;
  return guard("rc_gap_from_heights", [&] {
    if (n < 0) fail(RC_ERR_ARGUMENT, "n = ", n, " must be >= 0");
    const double* const z = host_values<double>(heights, "heights");
    const std::uint8_t* const wanted = host_values<std::uint8_t>(mask, "mask");
    double* const gap = host_values<double>(undeformed_gap, "undeformed_gap");
    if (n > 0 && (!z || !gap)) fail(RC_ERR_ARGUMENT, z ? "undeformed_gap" : "heights", " is null");
    double highest = -std::numeric_limits<double>::infinity();
    for (std::int64_t i = 0; i < n; ++i)
      if (!wanted || wanted[i] != 0) highest = std::fmax(highest, z[i]);   // passes over NaN
    if (highest == -std::numeric_limits<double>::infinity()) highest = 0;  // no point is there
    for (std::int64_t i = 0; i < n; ++i) gap[i] = highest - z[i];
    return RC_OK;
  });
}
