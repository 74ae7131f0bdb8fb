// Random numbers that are the same with every compiler and standard library: splitmix64 (Steele, Lea & Flood 2014).
#pragma once

#include <cmath>
#include <cstdint>

namespace scenes {

class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t stream) : state_(seed) {
    state_ = next() ^ stream;
    next();
  }

  /** 0 .. n-1 */
  std::int64_t below(std::int64_t n) { return static_cast<std::int64_t>(next() % static_cast<std::uint64_t>(n)); }
  /** first .. last */
  std::int64_t between(std::int64_t first, std::int64_t last) { return first + below(last - first + 1); }
  /** In [0, 1). */
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /** 10^low .. 10^high, every decade equally often. */
  double decades(double low, double high) { return std::pow(10, uniform(low, high)); }
  bool chance(double probability) { return uniform() < probability; }
  /** Mean 0, variance 1, within +-6: no function that libraries round differently. */
  double normal() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
  }
  template <class List> const auto& one_of(const List& list) {
    return list[static_cast<std::size_t>(below(static_cast<std::int64_t>(list.size())))];
  }

 private:
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace scenes
