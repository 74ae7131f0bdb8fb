// The methods whose speed and accuracy are compared: what the library offers for a system, by name.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "library.h"

namespace bench {

struct ParetoMethod {
  std::string solver, backend, variant;  // variant: what is set beside them, "" for the defaults
  Settings settings;
  double least_tol = 0;
};

// Every pair of solver and backend that the library supports for this system and control, and auto. Beside them haar-cg with
// products in double precision alone, and conjugate gradients with everything in single precision. Backends that factor matrices
// of candidates only up to `most_factored` of these.
std::vector<ParetoMethod> pareto_methods(const rc_system& system, std::int32_t control, std::int64_t candidates,
                                         std::int64_t most_factored);

}  // namespace bench
