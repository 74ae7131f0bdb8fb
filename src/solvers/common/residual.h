// How far pressures are from a solution, from their product with H.
#pragma once

#include "solvers/solver.h"

namespace rc {

struct Residual {
  double worst;     // largest violation of the KKT conditions, relative to the largest compenetration
  double approach;  // load control: the one that makes the mean gap of the contact set zero; else 0
  double scale;     // the largest compenetration
};

// Of p >= 0 with hp = H p. Contact is where p > 0.
Residual residual_of(const Problem& problem, const Vector& p, const Vector& hp);

// Load control: p scaled to the load, or spread evenly where p is zero. Displacement control: nothing.
void scale_to_load(const Problem& problem, Vector& p);

}  // namespace rc
