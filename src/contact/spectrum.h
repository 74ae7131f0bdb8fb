// Bounds of the operator's spectrum, which the proofs of bounds.h need.
#pragma once

#include "contact/system.h"

namespace rc {

// Bounds for the dimensionless operator. 0: not known.
struct Spectrum {
  double lowest = 0;          // no eigenvalue is smaller; periodic: but the mean's, which is 0
  double diagonal = 0;        // no diagonal entry is larger
  double flat_punch = 0;      // 1'H^-1 1 is no larger, on the whole grid and so on every part of it
  double galerkin_share = 0;  // x'Hx is at least this times that of the kernel galerkin
};

// A caller's matrix of at most this many points is factorised twice.
inline constexpr std::int64_t most_factorised_points = 1000;

Spectrum spectrum_of(const System&);

}  // namespace rc
