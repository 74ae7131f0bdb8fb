// A caller's product with a matrix that is stored.
#pragma once

#include <cstdint>
#include <numeric>

namespace support {

// rc_system.apply with the n x n entries as rc_system.user.
inline std::int32_t multiply(const double* x, double* y, std::int64_t n, void* entries) {
  const auto* row = static_cast<const double*>(entries);
  for (std::int64_t i = 0; i < n; ++i, row += n) y[i] = std::inner_product(x, x + n, row, 0.0);
  return 0;
}

}  // namespace support
