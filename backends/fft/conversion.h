// Scales vectors of double precision for products in single precision.
#pragma once

#include <cstdint>
#include <roughcontact/plugin.hpp>
#include <type_traits>

namespace rc_fft {

// x = mean + unit v and H x = offset + unit (H v), where v is multiplied in single precision.
struct Conversion {
  double mean = 0, unit = 1, offset = 0;

  // Neither direction rounds anything where both are of the same precision.
  template <class Real, class Outer> Real in(Outer x) const {
    if constexpr (std::is_same_v<Real, Outer>)
      return x;
    else
      return static_cast<Real>((x - mean) / unit);
  }
  template <class Outer, class Real> Outer out(Real y) const {
    if constexpr (std::is_same_v<Real, Outer>)
      return y;
    else
      return offset + unit * static_cast<Outer>(y);
  }
};

// The unit is a power of two with which v is near 1 and nothing over- or underflows. The second form multiplies the mean of x
// over all `points` apart; x is zero but for the n entries, and zero_mode is the eigenvalue of H for the constant vector.
// Otherwise a large mean, as near full contact, would leave single precision few digits for what varies.
Conversion conversion_of(const rc_team& team, std::int64_t n, const double* x);
Conversion conversion_of(const rc_team& team, std::int64_t n, const double* x, double zero_mode, std::int64_t points);

}  // namespace rc_fft
