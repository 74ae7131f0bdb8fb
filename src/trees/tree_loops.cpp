#include "trees/tree_loops.h"

#define RC_LOOPS "trees/tree_loops.inc"
#include "core/vectors/sets.inc"

namespace rc {

HaarRows best_haar_rows() { return RC_BEST(rows); }
template <class Real> HaarFinest<Real> best_haar_finest() { return RC_BEST(finest<Real>); }
template <class Real> HaarInner<Real> best_haar_inner() { return RC_BEST(inner<Real>); }

template HaarFinest<float> best_haar_finest();
template HaarFinest<double> best_haar_finest();
template HaarInner<float> best_haar_inner();
template HaarInner<double> best_haar_inner();

}  // namespace rc
