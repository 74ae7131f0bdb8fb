#include <algorithm>
#include <bit>
#include <type_traits>

#include "solvers/haar_cg/threads/pass_loops.h"

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#endif

#include "solvers/haar_cg/threads/matrix_loops.h"
#include "solvers/haar_cg/threads/tree_loops.h"

namespace rc {

namespace {

typedef double Doubles __attribute__((vector_size(64)));
typedef float Floats __attribute__((vector_size(32)));
typedef float ManyFloats __attribute__((vector_size(64)));
typedef std::int32_t Integers __attribute__((vector_size(32)));
typedef std::uint32_t Words __attribute__((vector_size(32)));
typedef std::int16_t Shorts __attribute__((vector_size(16)));
typedef std::uint16_t HalfWords __attribute__((vector_size(16)));
typedef std::uint64_t Eightfold;
typedef std::uint8_t Bytes __attribute__((vector_size(8)));

template <class R> struct Eight;
template <> struct Eight<float> { typedef Floats Value; };
template <> struct Eight<double> { typedef Doubles Value; };

// A vector at any address. It is a member of a packed struct, because compilers may drop the alignment of a type's alias.
template <class Type> struct __attribute__((packed, may_alias)) Anywhere { Type v; };

#define RC_INLINE RC_TARGET inline __attribute__((always_inline))
// Macros, because a function would not be compiled for the caller's vector instructions.
#define RC_READ(Type, from) (static_cast<Type>(reinterpret_cast<const Anywhere<Type>*>(from)->v))
#define RC_AT(Type, to) (reinterpret_cast<Anywhere<Type>*>(to)->v)
#define RC_TOTAL(v) ((((v)[0] + (v)[1]) + ((v)[2] + (v)[3])) + (((v)[4] + (v)[5]) + ((v)[6] + (v)[7])))

namespace baseline {
#define RC_TARGET
inline Floats looked_up(const float* table, const Integers& at) {
  Floats found;
  for (int i = 0; i < 8; ++i) found[i] = table[at[i]];
  return found;
}
#define RC_LOOKUP(table, at) looked_up(table, at)
#define RC_REGISTER 16
#include "solvers/haar_cg/threads/choices.inc"
#include "solvers/haar_cg/threads/matrix_loops.inc"
#include "solvers/haar_cg/threads/pass_loops.inc"
#include "solvers/haar_cg/threads/tree_loops.inc"
#undef RC_REGISTER
#undef RC_LOOKUP
#undef RC_TARGET
}  // namespace baseline

#if defined(__x86_64__) && defined(__GNUC__)
#define RC_HAS_WIDER 1

namespace avx2 {
#define RC_TARGET __attribute__((target("avx2")))
// Bit 3 of an index chooses between the lower and the upper eight of the 16 floats.
#define RC_LOOKUP(table, at)                                                                       \
  ((Floats)_mm256_blendv_ps(_mm256_permutevar8x32_ps(_mm256_loadu_ps(table), (__m256i)(at)),       \
                            _mm256_permutevar8x32_ps(_mm256_loadu_ps((table) + 8), (__m256i)(at)), \
                            _mm256_castsi256_ps(_mm256_slli_epi32((__m256i)(at), 28))))
#define RC_REGISTER 32
#include "solvers/haar_cg/threads/choices.inc"
#include "solvers/haar_cg/threads/matrix_loops.inc"
#include "solvers/haar_cg/threads/pass_loops.inc"
#include "solvers/haar_cg/threads/tree_loops.inc"
#undef RC_REGISTER
#undef RC_LOOKUP
#undef RC_TARGET
}  // namespace avx2

namespace avx512 {
#define RC_TARGET __attribute__((target("avx512f,avx512bw,avx512dq,avx512vl")))
#define RC_LOOKUP(table, at) ((Floats)_mm256_permutex2var_ps(_mm256_loadu_ps(table), (__m256i)(at), _mm256_loadu_ps((table) + 8)))
#define RC_REGISTER 64
#include "solvers/haar_cg/threads/choices.inc"
#include "solvers/haar_cg/threads/matrix_loops.inc"
#include "solvers/haar_cg/threads/pass_loops.inc"
#include "solvers/haar_cg/threads/tree_loops.inc"
#undef RC_REGISTER
#undef RC_LOOKUP
#undef RC_TARGET
}  // namespace avx512
#endif

}  // namespace

#ifdef RC_HAS_WIDER
namespace {

enum class Vectors { baseline, avx2, avx512 };

Vectors best() {
  if (__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq"))
    return Vectors::avx512;
  return __builtin_cpu_supports("avx2") ? Vectors::avx2 : Vectors::baseline;
}

}  // namespace

#define RC_BEST(...) \
  (best() == Vectors::avx512 ? avx512::__VA_ARGS__ : best() == Vectors::avx2 ? avx2::__VA_ARGS__ : baseline::__VA_ARGS__)
#else
#define RC_BEST(...) (baseline::__VA_ARGS__)
#endif

template <class Real, class Pressure> HaarLoops<Real, Pressure> best_haar_loops(bool capped) {
  return capped ? RC_BEST(loops<Real, Pressure, true>) : RC_BEST(loops<Real, Pressure, false>);
}
HaarRows best_haar_rows() { return RC_BEST(rows); }
MatrixLoops best_matrix_loops() { return RC_BEST(matrix_loops); }
template <class Real> HaarFinest<Real> best_haar_finest() { return RC_BEST(finest<Real>); }

template HaarLoops<float, float> best_haar_loops(bool);
template HaarLoops<float, double> best_haar_loops(bool);
template HaarLoops<double, double> best_haar_loops(bool);
template HaarFinest<float> best_haar_finest();
template HaarFinest<double> best_haar_finest();

}  // namespace rc
