#include "law/nesting.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/cholesky.h"

namespace rc {

bool sets_grow(const rc_system& system, const std::uint8_t* mask) {
  constexpr double doubt = 1e-10;  // of the inverse's diagonal: its round-off
  std::vector<std::int64_t> points;
  for (std::int64_t i = 0; i < system.nx * system.ny; ++i)
    if (!mask || mask[i] != 0) points.push_back(i);
  const std::size_t n = points.size();
  const Cholesky factor(n, [&](std::size_t i, std::size_t j) { return system.dense[points[i] * system.dense_ld + points[j]]; });
  if (!factor.positive()) return false;
  std::vector<double> sums(n, 1.0);
  factor.solve(sums);
  for (std::size_t j = 0; j < n; ++j) {
    std::vector<double> column(n, 0.0);
    column[j] = 1;
    factor.solve(column);
    const double least = doubt * column[j];
    if (!(sums[j] >= -least)) return false;
    for (std::size_t i = 0; i < n; ++i)
      if (i != j && !(column[i] <= least)) return false;
  }
  return true;
}

}  // namespace rc
