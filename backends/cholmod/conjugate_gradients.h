// A x = b by conjugate gradients with a preconditioner, as accurately as double precision allows.
#pragma once

#include <cstdint>
#include <functional>

namespace rc_cholmod {

struct Conclusion {
  std::int64_t iterations;
  double residual;   // largest component over the largest of b
  double curvature;  // of the last direction; not positive if A is not positive definite
};

// Returns in x the iterate of least residual. precondition(r): r = M^-1 r in place, or empty.
Conclusion conjugate_gradients(std::int64_t n, const std::function<void(const double* x, double* y)>& multiply,
                               const std::function<void(double* r)>& precondition, const double* b, double* x);

}  // namespace rc_cholmod
