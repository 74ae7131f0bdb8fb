#include "solvers/haar_loops.h"

namespace rc {

namespace {

typedef double Doubles __attribute__((vector_size(64), aligned(8), may_alias));
typedef std::uint8_t Bytes __attribute__((vector_size(8), aligned(1), may_alias));

template <class R> struct Eight;
template <> struct Eight<float> {
  typedef float Value __attribute__((vector_size(32), aligned(4), may_alias));
  typedef std::int32_t Mask __attribute__((vector_size(32)));
};
template <> struct Eight<double> {
  typedef Doubles Value;
  typedef std::int64_t Mask __attribute__((vector_size(64)));
};

// Macros: a function would not have the caller's instructions.
#define RC_READ(Type, from) (*reinterpret_cast<const Type*>(from))
#define RC_AT(Type, to) (*reinterpret_cast<Type*>(to))
#define RC_TOTAL(v) ((((v)[0] + (v)[1]) + ((v)[2] + (v)[3])) + (((v)[4] + (v)[5]) + ((v)[6] + (v)[7])))

namespace baseline {
#define RC_TARGET
#include "solvers/haar_loops.inc"
#undef RC_TARGET
}  // namespace baseline

#if defined(__x86_64__) && defined(__GNUC__)
#define RC_HAS_WIDER 1

namespace avx2 {
#define RC_TARGET __attribute__((target("avx2")))
#include "solvers/haar_loops.inc"
#undef RC_TARGET
}  // namespace avx2

namespace avx512 {
#define RC_TARGET __attribute__((target("avx512f,avx512bw,avx512dq,avx512vl")))
#include "solvers/haar_loops.inc"
#undef RC_TARGET
}  // namespace avx512
#endif

}  // namespace

template <class Real> HaarLoops<Real> best_haar_loops() {
#ifdef RC_HAS_WIDER
  if (__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq"))
    return avx512::loops<Real>;
  if (__builtin_cpu_supports("avx2")) return avx2::loops<Real>;
#endif
  return baseline::loops<Real>;
}

template HaarLoops<float> best_haar_loops();
template HaarLoops<double> best_haar_loops();

}  // namespace rc
