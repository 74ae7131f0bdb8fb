// Standard normal numbers that are bitwise equal on every machine: the generator std::mt19937_64, whose output the C++ standard
// fixes, and Marsaglia's polar method with a portable logarithm.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "portable_math.h"
#include "stop.h"

namespace rc::surface {

class Gaussian {
 public:
  explicit Gaussian(std::uint64_t seed) : integers_(seed) {}

  double operator()() {
    if (has_spare_) {
      has_spare_ = false;
      return spare_;
    }
    if ((++pairs_ & 0xffff) == 0) stop_if_asked();
    double u = 0, v = 0, s = 0;
    do {
      u = 2 * uniform() - 1;
      v = 2 * uniform() - 1;
      s = u * u + v * v;
    } while (s >= 1 || s == 0);
    const double scale = std::sqrt(-2 * portable_log(s) / s);
    spare_ = v * scale;
    has_spare_ = true;
    return u * scale;
  }

 private:
  double uniform() { return static_cast<double>(integers_() >> 11) * 0x1p-53; }  // [0, 1)

  std::mt19937_64 integers_;
  std::uint64_t pairs_ = 0;  // of numbers so far
  double spare_ = 0;
  bool has_spare_ = false;
};

}  // namespace rc::surface
