// Wilson's score interval (1927) for a proportion.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace failures {

struct Interval {
  double lower = 0, upper = 1;
};

inline Interval wilson(std::int64_t hits, std::int64_t trials, double z = 1.959963984540054) {
  const double n = static_cast<double>(trials), share = static_cast<double>(hits) / n, shrink = 1 + z * z / n;
  const double middle = (share + z * z / (2 * n)) / shrink;
  const double half = z / shrink * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
  return {hits == 0 ? 0 : std::max(0.0, middle - half), hits == trials ? 1 : std::min(1.0, middle + half)};
}

}  // namespace failures
