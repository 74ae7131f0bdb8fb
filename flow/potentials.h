// The potentials of a network: CHOLMOD, or conjugate gradients where its factor is too large.
#pragma once

#include "bounds.h"

namespace rc::flow {

struct Solved {
  Potentials potentials;
  std::int32_t iterations = 0;  // of conjugate gradients; 0: by the factor
};

// gap: of the cells on paths. fields: 1 with inlet and outlet, 2 in a cell that repeats. memory: most bytes for the factor. The
// potentials approximate those of least energy; nothing that is proven depends on how well.
Solved solve_potentials(const Grid& grid, const std::vector<double>& gap, const Paths& paths, std::size_t fields, double memory);

}  // namespace rc::flow
