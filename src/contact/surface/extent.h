// How many points there are, and their bounding box.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace rc {

struct Extent {
  std::int64_t n = 0;
  // Columns left .. right, rows low .. high.
  std::int64_t left = std::numeric_limits<std::int64_t>::max(), right = -1, low = left, high = -1;

  void add(std::int64_t x, std::int64_t y) {
    ++n;
    left = std::min(left, x);
    right = std::max(right, x);
    low = std::min(low, y);
    high = std::max(high, y);
  }
  std::int64_t width() const { return n > 0 ? right - left + 1 : 0; }
  std::int64_t height() const { return n > 0 ? high - low + 1 : 0; }
  std::int64_t box() const { return width() * height(); }

  friend Extent operator+(const Extent& a, const Extent& b) {
    return {a.n + b.n, std::min(a.left, b.left), std::max(a.right, b.right), std::min(a.low, b.low), std::max(a.high, b.high)};
  }
};

}  // namespace rc
