// The task of haar-cg's iteration, and how it ended.
#pragma once

#include <limits>

namespace rc {

struct HaarTask {
  bool by_load = false;                                  // the load is prescribed; otherwise the approach, which u contains
  double load = 0;                                       // the sum of p that is wanted
  double cap = std::numeric_limits<double>::infinity();  // the largest pressure
  double tol = 0;                                        // residual to reach, relative to the largest penetration
  double least_scale = 0;                                // by load: least penetration that residuals are relative to
  double periodic_mean = 0;                              // by how much every entry of the trees' operator exceeds that of H
  bool elongated = false;  // cells or grid are elongated: the trees may misjudge the load's slope by far
  int patience = 120;      // the iteration stalls after more bounds than this without half the residual
};

enum class HaarEnding { solved, stalled, not_finite, stopped };

struct HaarOutcome {
  HaarEnding ending;
  double approach;  // by load: the approach found
};

}  // namespace rc
