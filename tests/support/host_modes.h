// Floating-point modes that a host program may have.
#pragma once

#include <cfenv>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace support {

// set(): for the calling thread.
struct Mode {
  const char* name;
  void (*set)();
};

inline const Mode modes[] = {
#ifdef FE_NOMASK_ENV  // where traps can be set
    {"traps", [] { feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW); }},
#elif defined __SSE2__
    {"traps", [] { _mm_setcsr(_mm_getcsr() & ~(_MM_MASK_INVALID | _MM_MASK_DIV_ZERO | _MM_MASK_OVERFLOW)); }},
#endif
    {"upward", [] { std::fesetround(FE_UPWARD); }},
#ifdef __SSE2__
    {"flush to zero", [] { _mm_setcsr(_mm_getcsr() | 0x8040); }},
#endif
};

// All that a thread's mode consists of.
struct Found {
  int rounding = std::fegetround(), raised = std::fetestexcept(FE_ALL_EXCEPT), trapped = 0;
  unsigned vectors = 0;

  Found() {
#ifdef FE_NOMASK_ENV  // where traps can be set
    trapped = fegetexcept();
#endif
#ifdef __SSE2__
    vectors = _mm_getcsr();
#endif
  }
  bool operator==(const Found&) const = default;
};

// Until its end the thread has the mode.
class InMode {
 public:
  explicit InMode(const Mode& mode) {
    std::fegetenv(&before_);
    std::feclearexcept(FE_ALL_EXCEPT);
    mode.set();
  }
  ~InMode() {
    std::fesetenv(&before_);
#ifdef __SSE2__  // MinGW's fesetenv leaves it alone
    _mm_setcsr(vectors_);
#endif
  }
  InMode(const InMode&) = delete;
  InMode& operator=(const InMode&) = delete;

 private:
  std::fenv_t before_;
#ifdef __SSE2__
  unsigned vectors_ = _mm_getcsr();
#endif
};

}  // namespace support
