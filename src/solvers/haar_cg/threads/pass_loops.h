// The inner loops of the passes over all unknowns, for the best vector instructions of this processor.
#pragma once

#include <cstdint>

#include "core/vectors/run_state.h"
#include "solvers/haar_cg/iteration/machine.h"

namespace rc {

// The new w: w + change, w - shift, w + shift (w + u), product - u - shift, -u - shift.
enum class HaarUpdate { add, lower, grow, replace, begin };

// The result of cutting pressures to the bounds.
struct HaarCut {
  double load = 0;      // the sum of those kept
  bool any = false;     // some were cut
  bool capped = false;  // some are at the cap
};

// Loops over n values, with sums in a fixed order. `active` is the free set, `runs` [n / run_points, rounded up] the states of
// its runs; off it p is 0 or the cap. Pressure: the precision of p.
template <class Real, class Pressure> struct HaarLoops {
  using Measure = HaarMeasure (*)(std::int64_t n, Real* w, const Real* change, const Pressure* product, double shift,
                                  const double* u, const Pressure* p, double cap, const RunState* runs);
  using Choose = bool (*)(std::int64_t n, const Pressure* p, double cap, const Real* w, Real limit, std::uint8_t* active,
                          RunState* runs);
  using Cut = HaarCut (*)(std::int64_t n, double length, const Real* t, const Real* q, Pressure* p, double cap, Real* w,
                          Real* cut, const RunState* runs);

  // t = z + beta t where active, 0 elsewhere. Returns (w, t).
  double (*turn)(std::int64_t n, const Real* z, Real beta, Real* t, const Real* w, const std::uint8_t* active, RunState* runs);
  // p -= length t, w -= length q
  void (*advance)(std::int64_t n, double length, const Real* t, const Real* q, Pressure* p, Real* w, const RunState* runs);
  // The same, then p = min(max(p, 0), cap); cut: what that added to p, and as it is, 0, in runs that are not busy.
  Cut advance_and_cut;
  // After a cut: each strip keeps the load that it had before; cut: also what that added to p. Returns the sum of p.
  double (*keep_loads)(std::int64_t n, Pressure* p, double cap, Real* cut, const RunState* runs);
  // p = min(number p, cap) below the cap; cut: what that added to p, and what it was before with yes; as it is, 0, in runs that
  // are not busy. Returns whether some are at the cap.
  bool (*scale)(std::int64_t n, double number, Pressure* p, double cap, Real* cut, bool yes, const RunState* runs);
  // Without a cap add and lower read u only in runs that are busy.
  Measure add, lower, grow, replace, begin;
  // active = p > 0 or w < -limit, and where p = cap: w > limit. Returns whether it changed.
  Choose choose;
  // u = (approach - gap) * per_length
  void (*compenetrate)(std::int64_t n, const double* gap, double approach, double per_length, double* u);
  void (*compenetrate_single)(std::int64_t n, const float* gap, double approach, double per_length, double* u);
};

// capped: for values of which some are, or may come, at the cap. The others neither read the cap nor p off the free set.
template <class Real, class Pressure> HaarLoops<Real, Pressure> best_haar_loops(bool capped = false);

}  // namespace rc
