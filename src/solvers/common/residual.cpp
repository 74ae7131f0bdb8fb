#include "solvers/common/residual.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/sums.h"

namespace rc {

Residual residual_of(const Problem& problem, const Vector& p, const Vector& hp) {
  const double* u = problem.u();
  const std::size_t n = p.size();
  Residual result{0, 0, 1};
  if (problem.load_control()) {
    const double count = sum_of(n, [&](std::size_t i) { return p[i] > 0 ? 1.0 : 0.0; });
    result.approach = sum_of(n, [&](std::size_t i) { return p[i] > 0 ? hp[i] - u[i] : 0.0; }) / count;
    result.scale = std::max(result.approach + *std::max_element(u, u + n), problem.least_scale());
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double gap = hp[i] - u[i] - result.approach, violation = p[i] > 0 ? std::abs(gap) : -gap;
    if (std::isnan(violation)) problem.fail("the operator returned values that are not finite");
    result.worst = std::max(result.worst, violation);
  }
  result.worst = result.scale > 0 ? result.worst / result.scale : std::numeric_limits<double>::infinity();
  return result;
}

void scale_to_load(const Problem& problem, Vector& p) {
  if (!problem.load_control()) return;
  const double sum = sum_of(p.size(), [&](std::size_t i) { return p[i]; });
  for (double& value : p) value = sum > 0 ? value * (problem.load() / sum) : problem.load() / static_cast<double>(p.size());
}

}  // namespace rc
