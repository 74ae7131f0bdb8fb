// The library's own check of an answer, from one fresh product with H over all points.
#pragma once

#include "contact/pressures.h"
#include "contact/surface_state.h"

namespace rc {

struct Certificate {
  double primal = 0;           // max(0, -min p) / max|p|
  double dual = 0;             // max(0, -min g) / s over all points, s = max(d - h)
  double complementarity = 0;  // max over all points of min(p / max p, |g| / s)
  double control = 0;          // |load - W| / W

  bool within(double tol) const;  // false if any is NaN
};

// Excluded points have p = 0 and do not count; points that are not listed have p = 0 and g >= 0.
// least_deflection: of a cell under unit pressure on it alone; in full periodic contact the compenetration may vanish under any
// pressure, and residuals are relative to what the largest pressure does by itself.
Certificate certify(const SurfaceState& surface, double approach, const Deflected& answer, double least_deflection);

// |load - wanted| / wanted; 0 if both are 0.
double load_imbalance(double load, double wanted);

}  // namespace rc
