// The conductance of a gap with both bounds, for any units.
#pragma once

#include <vector>

#include "potentials.h"

namespace rc::flow {

// A gap on the grid, and what the exact one lies between [length].
struct Gap {
  std::vector<double> least, computed, most;
};

struct Wanted {
  double width;   // upper - lower over upper
  double memory;  // most bytes for the factor; 0: the machine's
};

struct Conductance {
  Tensor lower, computed, upper;  // [length^3]
  bool narrow = true;             // the width is as wanted
  double constriction = 0;        // of the computed gap [length]
  std::int64_t place = outside;   // its cell
  double dropped = 0;             // share of the cells that the lower bound closes though they are open
  std::int32_t iterations = 0;    // of conjugate gradients
  std::vector<double> potential;  // of each cell for a drop along x; NaN where nothing flows
};

Conductance conductance(const Grid& grid, Gap gap, const Wanted& wanted);

}  // namespace rc::flow
