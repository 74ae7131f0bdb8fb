// Which of a function's three builds this processor runs best. It is asked when an operator is set up. An ifunc, chosen when the
// program is loaded, would not work with sanitizers.
#pragma once

// RC_BASELINE_VECTORS: the baseline's build alone.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(RC_BASELINE_VECTORS)
#define RC_HAS_WIDER_VECTORS
#endif

namespace rc_common {

enum class Vectors { baseline, avx2, avx512 };

// avx2 includes fused multiplication and addition; avx512 also the instructions for doubles and quadwords.
inline Vectors widest_vectors() {
#ifdef RC_HAS_WIDER_VECTORS
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") ? Vectors::avx512 : Vectors::avx2;
#endif
  return Vectors::baseline;
}

}  // namespace rc_common

// One of three values. The last two need not exist on other processors.
#ifdef RC_HAS_WIDER_VECTORS
#define RC_FOR_THIS_PROCESSOR(any, with_avx2, with_avx512)                   \
  (rc_common::widest_vectors() == rc_common::Vectors::avx512 ? (with_avx512) \
   : rc_common::widest_vectors() == rc_common::Vectors::avx2 ? (with_avx2)   \
                                                             : (any))
#else
#define RC_FOR_THIS_PROCESSOR(any, with_avx2, with_avx512) (any)
#endif
