// Limits of double precision by short names.
#pragma once

#include <cstdint>
#include <limits>

namespace rc {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr std::int64_t most_threads = 1024;  // of option threads
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

}  // namespace rc
