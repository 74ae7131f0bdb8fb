#include "solvers/haar_cg/threads/pass_loops.h"

#define RC_LOOPS "solvers/haar_cg/threads/pass_loops.inc"
#include "core/vectors/sets.inc"

namespace rc {

template <class Real, class Pressure> HaarLoops<Real, Pressure> best_haar_loops(bool capped) {
  return capped ? RC_BEST(loops<Real, Pressure, true>) : RC_BEST(loops<Real, Pressure, false>);
}

template HaarLoops<float, float> best_haar_loops(bool);
template HaarLoops<float, double> best_haar_loops(bool);
template HaarLoops<double, double> best_haar_loops(bool);

}  // namespace rc
