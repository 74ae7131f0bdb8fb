// Which lengths the transforms have.
#pragma once

#include <cstdint>

namespace rc_fft {

// Array lengths of a transform along x and y.
struct Lengths {
  std::int64_t x = 0, y = 0;

  bool operator==(const Lengths&) const = default;
};

inline double points(Lengths l) { return static_cast<double>(l.x) * static_cast<double>(l.y); }

// The largest grid along one axis: four times it still fits an int.
inline constexpr std::int64_t longest_axis = (std::int64_t{1} << 29) - 1;

// Least length along one axis at which the circular product with an even kernel equals the one with free boundaries, for sources
// at [begin, begin + count) and targets at [0, extent).
std::int64_t exact_length(std::int64_t begin, std::int64_t count, std::int64_t extent);

// No prime factor above 7.
bool has_small_factors(std::int64_t length);

// The length >= at_least that is expected to be transformed fastest: 1, or even with no prime factor above 7.
std::int64_t fast_length(std::int64_t at_least);

// Whether a transform takes long enough to be worth waking other threads for: some tenths of a millisecond.
inline bool worth_sharing(Lengths l) { return points(l) >= 1e5; }

// The periods of a grid that repeats along one axis, where they are fast lengths; else 0. A circular product of this length is
// exact for any sources and targets.
Lengths periods(Lengths grid, bool repeats_x, bool repeats_y);

// fast_length() of each axis, but no longer than a period.
Lengths fast_lengths(Lengths needed, Lengths period = {});

bool covers(Lengths have, Lengths needed, Lengths period = {});

// Whether lengths cover what is needed and are not much too long.
bool suits(Lengths have, Lengths needed, Lengths period = {});

// Lengths for a transform that has to cover `needed`, never more than what covers `largest`. The present ones are kept
// if they suit; if they have been outgrown, the new ones leave room for the next growth.
Lengths choose_lengths(Lengths needed, Lengths largest, Lengths present, Lengths period = {});

}  // namespace rc_fft
