// The residual of given pressures, from their product with H.
#pragma once

#include "solvers/solver.h"

namespace rc {

struct Residual {
  double worst;     // largest violation of the KKT conditions, relative to the largest compenetration
  double approach;  // load control: the approach at which the contact set has a mean gap of 0; else 0
  double scale;     // the largest compenetration, or Problem::least_scale if that is larger
};

// The residual of p >= 0 with hp = H p. Points with p > 0 are in contact.
Residual residual_of(const Problem& problem, const Vector& p, const Vector& hp);

// Load control: scales p to the load; a p of zeros becomes the load spread evenly. Displacement control: does nothing.
void scale_to_load(const Problem& problem, Vector& p);

}  // namespace rc
