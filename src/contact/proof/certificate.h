// The library's own check of an answer, from one fresh product with H over all points.
#pragma once

#include <algorithm>

#include "contact/problem.h"
#include "contact/proof/survey.h"
#include "contact/surface/pressures.h"
#include "contact/surface/step_surface.h"
#include "contact/target.h"

namespace rc {

struct Certificate {
  double primal = 0;           // max(0, -min p) / max|p|, and max(0, max p - c) / c
  double dual = 0;             // max over all points with g < 0 of min(1 - p / c, |g| / s)
  double complementarity = 0;  // max over all points of min(p / max p, |g| / s), for g < 0 of min(p / max p, 1 - p / c, |g| / s)
  double control = 0;          // |load - W| / W

  bool within(double tol) const;  // false if any is NaN
  double worst() const { return std::max({primal, dual, complementarity, control}); }
};

// The scale s [length] that residuals of gaps are relative to.
double residual_scale(const GridProblem& problem, const Target& target, double compression);

// g is the deformed gap, c the hardness, which may be infinite. Excluded points have p = 0 and do not count; points that are not
// listed have p = 0 and g >= 0. found: of the answer.
Certificate certify(const StepSurface& surface, double compression, const Deflected& answer, const Survey& found, double scale,
                    double hardness);

}  // namespace rc
