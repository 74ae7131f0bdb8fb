// Logarithm and exponential from + - * / alone. IEEE 754 fixes their rounding, so results are the same bits everywhere, unlike
// libm's.
#pragma once

#include <cmath>

namespace rc::surface {

inline constexpr double ln2 = 0.69314718055994530942;

// ln(x) for finite x > 0, to about 2e-16: x = m 2^e with m near 1, ln m = 2 artanh((m - 1)/(m + 1)).
inline double portable_log(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < 0.70710678118654752) {
    m *= 2;
    --exponent;
  }
  const double s = (m - 1) / (m + 1), s2 = s * s;
  double series = 0;
  for (int k = 25; k >= 1; k -= 2) series = series * s2 + 1.0 / k;
  return 2 * s * series + exponent * ln2;
}

// exp(x) for |x| <= 1, to about 2e-16, by its power series.
inline double portable_exp(double x) {
  double series = 1;
  for (int k = 20; k >= 1; --k) series = 1 + series * x / k;
  return series;
}

}  // namespace rc::surface
