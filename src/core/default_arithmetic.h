// Shields computations from the host program's floating-point mode.
#pragma once

#include <cfenv>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace rc {

// Sets the default mode for the calling thread and for threads that it starts: rounding to nearest, subnormal numbers, no traps.
// Vector loops may divide by zero in lanes whose results are discarded, so traps must be off. The destructor restores the mode
// and the exception flags.
class DefaultArithmetic {
 public:
  DefaultArithmetic() {
    std::fegetenv(&given_);
    std::fesetenv(FE_DFL_ENV);
#ifdef __SSE2__
    _mm_setcsr(0x1f80);  // the default of processors
#endif
  }
  ~DefaultArithmetic() {
    std::fesetenv(&given_);
#ifdef __SSE2__
    _mm_setcsr(given_vectors_);
#endif
  }
  DefaultArithmetic(const DefaultArithmetic&) = delete;
  DefaultArithmetic& operator=(const DefaultArithmetic&) = delete;

 private:
  std::fenv_t given_;
#ifdef __SSE2__
  unsigned given_vectors_ = _mm_getcsr();  // x86 computes doubles with vectors, whose mode MinGW's fesetenv leaves alone
#endif
};

}  // namespace rc
