// Standard normal numbers that are bitwise equal on every machine.
#pragma once

#include <cstdint>

#include "core/normal_numbers.h"
#include "portable_math.h"
#include "stop.h"

namespace rc::surface {

class Gaussian {
 public:
  explicit Gaussian(std::uint64_t seed) : normal_(seed) {}

  double operator()() {
    if ((++numbers_ & 0x1ffff) == 0) stop_if_asked();
    return normal_();
  }

 private:
  NormalNumbers<portable_log> normal_;
  std::uint64_t numbers_ = 0;  // so far
};

}  // namespace rc::surface
