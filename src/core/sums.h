// Sums in a fixed order, so that the same numbers give the same bits.
#pragma once

#include <cstddef>

namespace rc {

// term(0) + .. + term(n - 1) in eight partial sums: fast without relaxed floating point.
inline constexpr auto sum_of = [](std::size_t n, const auto& term) {
  double lane[8] = {};
  std::size_t i = 0;
  for (; i + 8 <= n; i += 8)
    for (std::size_t k = 0; k < 8; ++k) lane[k] += term(i + k);
  for (std::size_t k = 0; i < n; ++i, ++k) lane[k] += term(i);
  return ((lane[0] + lane[1]) + (lane[2] + lane[3])) + ((lane[4] + lane[5]) + (lane[6] + lane[7]));
};

// The same, one term after the other.
inline constexpr auto sum_in_order = [](std::size_t n, const auto& term) {
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += term(i);
  return sum;
};

}  // namespace rc
