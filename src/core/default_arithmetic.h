// The host program's floating-point mode does not reach what the library computes.
#pragma once

#include <cfenv>

namespace rc {

// Until its end the calling thread, and threads that it starts, compute as programs do by default: to nearest, with subnormal
// numbers, and without a signal where a result is not finite or not a number, which passes over many values at a time may meet in
// lanes that nobody reads. Then the host's mode, with its traps and flags, is as it was.
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
