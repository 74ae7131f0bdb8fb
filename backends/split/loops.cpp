#include "loops.h"

namespace rc_split {

namespace {

// Of any scheme, rounded up to whole vectors.
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

#if defined(__x86_64__) && defined(__GNUC__)
#define RC_HAS_WIDER 1

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

template <class T> Loops<T> best_loops() {
#ifdef RC_HAS_WIDER
  if (__builtin_cpu_supports("avx512f")) return avx512::loops<T>;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return avx2::loops<T>;
#endif
  return baseline::loops<T>;
}

template Loops<float> best_loops();
template Loops<double> best_loops();

}  // namespace rc_split
