// Independent standard normal numbers from the generator std::mt19937_64, whose output the C++ standard fixes, by Marsaglia's
// polar method. `logarithm` decides whether they have the same bits on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace rc {

template <double logarithm(double)> class NormalNumbers {
 public:
  explicit NormalNumbers(std::uint64_t seed) : integers_(seed) {}

  double operator()() {
    if (has_spare_) {
      has_spare_ = false;
      return spare_;
    }
    double u = 0, v = 0, s = 0;
    do {
      u = 2 * uniform() - 1;
      v = 2 * uniform() - 1;
      s = u * u + v * v;
    } while (s >= 1 || s == 0);
    const double scale = std::sqrt(-2 * logarithm(s) / s);
    spare_ = v * scale;
    has_spare_ = true;
    return u * scale;
  }

  double uniform() { return static_cast<double>(integers_() >> 11) * 0x1p-53; }  // [0, 1)

 private:
  std::mt19937_64 integers_;
  double spare_ = 0;
  bool has_spare_ = false;
};

}  // namespace rc
