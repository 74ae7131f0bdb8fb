#include "loops.h"

#include "common/processor.h"

namespace rc_split {

namespace {

// The largest number of nodes of any scheme, rounded up to whole vectors.
constexpr std::int64_t largest_stride = 32;

namespace baseline {
#define RC_TARGET
#define RC_BYTES 16
#define RC_ROWS 8
#include "loops.inc"
#undef RC_ROWS
#undef RC_BYTES
#undef RC_TARGET
}  // namespace baseline

#ifdef RC_HAS_WIDER_VECTORS

namespace avx2 {
#define RC_TARGET __attribute__((target("avx2,fma")))
#define RC_BYTES 32
#define RC_ROWS 8
#include "loops.inc"
#undef RC_ROWS
#undef RC_BYTES
#undef RC_TARGET
}  // namespace avx2

namespace avx512 {
#define RC_TARGET __attribute__((target("avx512f,avx2,fma")))
#define RC_BYTES 64
#define RC_ROWS 16
#include "loops.inc"
#undef RC_ROWS
#undef RC_BYTES
#undef RC_TARGET
}  // namespace avx512
#endif

}  // namespace

template <class T> Loops<T> best_loops() { return RC_FOR_THIS_PROCESSOR(baseline::loops<T>, avx2::loops<T>, avx512::loops<T>); }

template Loops<float> best_loops();
template Loops<double> best_loops();

}  // namespace rc_split
