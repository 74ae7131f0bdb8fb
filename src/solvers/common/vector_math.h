// Sums in a fixed order of eight partial sums: repeatable, and fast without relaxed floating point.
#pragma once

#include <cstddef>

namespace rc {

template <class Term> double sum_of(std::size_t n, const Term& term) {
  double lane[8] = {};
  std::size_t i = 0;
  for (; i + 8 <= n; i += 8)
    for (std::size_t k = 0; k < 8; ++k) lane[k] += term(i + k);
  for (std::size_t k = 0; i < n; ++i, ++k) lane[k] += term(i);
  return ((lane[0] + lane[1]) + (lane[2] + lane[3])) + ((lane[4] + lane[5]) + (lane[6] + lane[7]));
}

}  // namespace rc
