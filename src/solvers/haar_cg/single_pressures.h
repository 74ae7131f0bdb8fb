// Pressures in single precision in the memory of those in double, whose other half is free meanwhile.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>

#include "core/chunks.h"

namespace rc {

// While it lives, p [n] holds n floats, and room for as many more. Then p has their values, and the cap itself where a float is
// no less than the one next to it.
class SinglePressures {
 public:
  SinglePressures(std::span<double> p, double cap, const rc_team& team)
      : p_(reinterpret_cast<std::byte*>(p.data())), n_(static_cast<std::int64_t>(p.size())), cap_(cap), team_(team) {
    // The converted values of a range lie before the range, except for the first value.
    for (std::int64_t begin = 0, end = std::min<std::int64_t>(1, n_); begin < n_; begin = end, end = std::min(2 * end, n_))
      convert<double, float>(begin, end);
  }
  ~SinglePressures() {
    std::int64_t end = n_;
    while (end > 1) {
      const std::int64_t begin = (end + 1) / 2;
      convert<float, double>(begin, end);
      end = begin;
    }
    convert<float, double>(0, end);
  }
  SinglePressures(const SinglePressures&) = delete;
  SinglePressures& operator=(const SinglePressures&) = delete;

  float* values() const { return reinterpret_cast<float*>(p_); }
  float* room() const { return values() + n_; }

 private:
  static float other_of(double value) { return static_cast<float>(value); }
  double other_of(float value) const { return value >= static_cast<float>(cap_) ? cap_ : static_cast<double>(value); }
  template <class From, class To> void convert(std::int64_t begin, std::int64_t end) {
    each_chunk(end - begin, team_, [&](std::int64_t first, std::int64_t count) {
      for (std::int64_t i = begin + first; i < begin + first + count; ++i) {
        From value;
        std::memcpy(&value, p_ + i * static_cast<std::int64_t>(sizeof value), sizeof value);
        const To other = other_of(value);
        std::memcpy(p_ + i * static_cast<std::int64_t>(sizeof other), &other, sizeof other);
      }
    });
  }

  std::byte* const p_;
  const std::int64_t n_;
  const double cap_;
  const rc_team& team_;
};

}  // namespace rc
