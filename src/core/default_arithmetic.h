// Shields computations from the host program's floating-point mode.
#pragma once

#include <cfenv>

namespace rc {

// Sets the default mode for the calling thread and for threads that it starts: rounding to nearest, subnormal numbers, no traps.
// Vector loops may divide by zero in lanes whose results are discarded, so traps must be off. The destructor restores the mode
// and the exception flags.
class DefaultArithmetic {
 public:
  DefaultArithmetic() {
    std::fegetenv(&given_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~DefaultArithmetic() { std::fesetenv(&given_); }
  DefaultArithmetic(const DefaultArithmetic&) = delete;
  DefaultArithmetic& operator=(const DefaultArithmetic&) = delete;

 private:
  std::fenv_t given_;
};

}  // namespace rc
