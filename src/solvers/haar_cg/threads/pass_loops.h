// The inner loops of the passes over all unknowns, for the best vector instructions of this processor.
#pragma once

#include <cstdint>

#include "solvers/haar_cg/machine.h"

namespace rc {

// The new w: w + change, w - shift, product - u - shift, -u - shift.
enum class HaarUpdate { add, lower, replace, begin };

// Loops over n values, with sums in a fixed order. p is 0 off the contact set `active`.
template <class Real> struct HaarLoops {
  using Measure = HaarMeasure (*)(std::int64_t n, Real* w, const Real* change, const double* product, double shift,
                                  const double* u, const double* p, const std::uint8_t* active);

  // t = z + beta t where active, 0 elsewhere. Returns (w, t).
  double (*turn)(std::int64_t n, const Real* z, Real beta, Real* t, const Real* w, const std::uint8_t* active);
  // Returns (a, b), where a is 0 off the contact set.
  double (*inner)(std::int64_t n, const Real* a, const Real* b, const std::uint8_t* active);
  // p -= length t, w -= length q
  void (*advance)(std::int64_t n, double length, const Real* t, const Real* q, double* p, Real* w, const std::uint8_t* active);
  // The same, then p = max(p, 0); cut: what that added to p. Returns whether it added any.
  bool (*advance_and_cut)(std::int64_t n, double length, const Real* t, const Real* q, double* p, Real* w, Real* cut,
                          const std::uint8_t* active);
  Measure add, lower, replace, begin;
  // active = p > 0 or w < limit. Returns whether it changed.
  bool (*choose)(std::int64_t n, const double* p, const Real* w, Real limit, std::uint8_t* active);
};

template <class Real> HaarLoops<Real> best_haar_loops();

}  // namespace rc
