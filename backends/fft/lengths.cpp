#include "lengths.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace rc_fft {

namespace {

// Time that each prime factor adds to that of an element, relative to the factor 2, from timings of column transforms of all such
// lengths from 32 to 2600 in both precisions; 3.2 is what an element costs besides. Factors 2 are cheap, as a pass takes three.
constexpr double pass3 = 2.9, pass5 = 3.5, pass7 = 4.5, overhead = 3.2;

std::int64_t roomy(std::int64_t needed) { return needed + needed / 16; }

std::int64_t outgrown(std::int64_t needed, std::int64_t largest, std::int64_t present) {
  return present >= needed ? needed : std::min(roomy(needed), largest);
}

}  // namespace

std::int64_t exact_length(std::int64_t begin, std::int64_t count, std::int64_t extent) {
  // Offsets d and d - length share a coefficient, so |d| may be at most half the length.
  const std::int64_t reach = std::max(begin + count - 1, extent - 1 - begin);
  return std::max(2 * reach, extent);
}

bool has_small_factors(std::int64_t length) {
  for (const int p : {2, 3, 5, 7})
    while (length % p == 0) length /= p;
  return length == 1;
}

std::int64_t fast_length(std::int64_t at_least) {
  if (at_least <= 1) return 1;
  std::int64_t fastest = 0;
  double least = std::numeric_limits<double>::infinity();
  double cost7 = overhead;
  for (std::int64_t p7 = 1; p7 < at_least; p7 *= 7, cost7 += pass7) {
    double cost5 = cost7;
    for (std::int64_t p5 = p7; p5 < at_least; p5 *= 5, cost5 += pass5) {
      double cost3 = cost5;
      for (std::int64_t p3 = p5; p3 < at_least; p3 *= 3, cost3 += pass3) {
        // The odd part is less than at_least, so at least one factor 2 follows.
        const auto parts = static_cast<std::uint64_t>((at_least + p3 - 1) / p3);
        const int twos = static_cast<int>(std::bit_width(parts - 1));
        const std::int64_t length = p3 << twos;
        const double cost = static_cast<double>(length) * (cost3 + twos);
        if (cost < least) {
          least = cost;
          fastest = length;
        }
      }
    }
  }
  return fastest;
}

Lengths periods(Lengths grid, bool repeats_x, bool repeats_y) {
  const auto period = [](bool repeats, std::int64_t points) { return repeats && has_small_factors(points) ? points : 0; };
  return {period(repeats_x, grid.x), period(repeats_y, grid.y)};
}

Lengths fast_lengths(Lengths needed, Lengths period) {
  const auto fast = [](std::int64_t at_least, std::int64_t most) {
    const std::int64_t length = fast_length(at_least);
    return most > 0 ? std::min(length, most) : length;
  };
  return {fast(needed.x, period.x), fast(needed.y, period.y)};
}

bool covers(Lengths have, Lengths needed, Lengths period) {
  const auto enough = [](std::int64_t length, std::int64_t least, std::int64_t repeat) {
    return length >= least || (repeat > 0 && length == repeat);
  };
  return enough(have.x, needed.x, period.x) && enough(have.y, needed.y, period.y);
}

bool suits(Lengths have, Lengths needed, Lengths period) {
  // A length that was chosen with room for growth suits at once, however far apart fast lengths are.
  const double usual = 1.3 * points(fast_lengths(needed, period));
  const double grown = points(fast_lengths({roomy(needed.x), roomy(needed.y)}, period));
  return covers(have, needed, period) && points(have) <= std::max(usual, grown);
}

Lengths choose_lengths(Lengths needed, Lengths largest, Lengths present, Lengths period) {
  if (suits(present, needed, period)) return present;
  if (present.x == 0 || covers(present, needed, period)) return fast_lengths(needed, period);
  return fast_lengths({outgrown(needed.x, largest.x, present.x), outgrown(needed.y, largest.y, present.y)}, period);
}

}  // namespace rc_fft
