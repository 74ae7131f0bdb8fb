// The mathematics a second time, without the library: plain sums over pairs of points, with the coefficients of the scenes'
// oracle.
#pragma once

#include <string>

#include "support/contact.h"

namespace pairs {

/** E* times the deflection of the cell (ix, iy) under unit pressure on cell (0, 0) of a free half-space. */
double coefficient(const std::string& kernel, std::int64_t ix, std::int64_t iy, double hx, double hy);

/** n x n, row by row [length per pressure]. "auto" is love, spectral for periodic boundaries. */
Field influence_matrix(const Problem& problem);
Field product(const Field& matrix, const Field& x);

struct Certificate {
  double primal, dual, complementarity, control;
  double load, energy;
  std::int64_t contacts;
  Field gap;
};
Certificate certificate(const Problem& problem, const Field& matrix, const Field& p, double approach);

/** The answer's residuals, load, energy, counts and gap are those of its pressures and approach. */
void check_against_naive(const Problem& problem, const Answer& answer);

}  // namespace pairs
