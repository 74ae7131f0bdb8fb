// The accuracy of a residual in the machine's precision, and when a product in double precision replaces it.
#pragma once

#include "core/by_value.h"

namespace rc {

template <class Real> class HaarPrecision {
 public:
  static constexpr bool single = sizeof(Real) < sizeof(double);
  static constexpr double merit_noise = single ? 1e-6 : 1e-10;  // relative rise of the merit that rounding explains

  constexpr void refreshed() { bounds_ = 0; }                   // by a product in double precision
  constexpr void found(double residual) { exact_ = residual; }  // by that
  // A w has changed by this much. The residual did not contain it before, and may contain it now.
  constexpr void moved(double change) { exact_ = larger_of(exact_, change); }
  constexpr bool refresh_due() { return ++bounds_ >= refresh_every; }  // after a bound
  constexpr bool fresh() const { return bounds_ == 0; }                // no bound since the last one
  constexpr bool blurred(double residual) const { return single && residual <= drop * exact_; }
  // Whether another product in double precision would not be more accurate than a residual that meets the tolerance.
  constexpr bool known(double residual, double tol) const {
    return tol >= larger_of(sure * exact_, rounding) && residual <= surely * tol;
  }

 private:
  static constexpr int refresh_every = 12;              // bounds between two refreshes, which remove drift
  static constexpr double drop = single ? 1e-4 : 0;     // fall of the residual up to which single precision is reliable
  static constexpr double sure = single ? 1e-3 : 1e-9;  // the same, for all but a small part of the residual
  static constexpr double rounding = 1e-10;             // ten times what two products in double precision differ by
  static constexpr double surely = 0.9;                 // of the tolerance: a residual that has such an error

  double exact_ = 1;  // residual of the last product in double precision
  int bounds_ = 0;    // since then
};

}  // namespace rc
