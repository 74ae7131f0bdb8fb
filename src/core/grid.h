// The grid of a system, checked.
#pragma once

#include <roughcontact/roughcontact.h>

#include <cstddef>
#include <cstdint>
#include <limits>

namespace rc {

// Arrays of complex numbers over all points of a padded grid must be addressable, with room for more where pointers have 64 bits.
constexpr std::int64_t most_points = std::numeric_limits<std::ptrdiff_t>::max() / (sizeof(void*) == 8 ? 1024 : 64);

// Operator kind, boundary, points and cell size. Throws Error(ARGUMENT, SHAPE).
void check_grid(const rc_system& system);

}  // namespace rc
