// The residual of given pressures, from their product with H.
#pragma once

#include "solvers/solver.h"

namespace rc {

struct Residual {
  double worst;     // largest violation of the KKT conditions, relative to the largest penetration
  double approach;  // load control: the approach at which the points with 0 < p < cap have a mean gap of 0; where there are
                    // none, the least at which no point at the cap has a gap or, if others overlap there, one between; else 0
  double scale;     // the largest penetration, or Problem::least_scale if that is larger
};

// The residual of 0 <= p <= cap with hp = H p. Points with p > 0 are in contact; those with p = cap may overlap.
Residual residual_of(const Problem& problem, const Vector& p, const Vector& hp);

// The p between 0 and the cap.
void clip(const Problem& problem, Vector& p);
// Moves v to the nearest point of { 0 <= p <= cap } or, in load control, of { 0 <= p <= cap, sum p = load }.
void project(const Problem& problem, Vector& v);
// Load control: scales the p below the cap to the load, again for those that meet the cap; a p of zeros becomes the load spread
// evenly. Where they cannot bear the load, p is projected. Approach control: does nothing.
void scale_to_load(const Problem& problem, Vector& p);

}  // namespace rc
