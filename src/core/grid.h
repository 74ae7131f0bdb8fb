// The grid of a system, checked.
#pragma once

#include <roughcontact/roughcontact.h>

#include <cstdint>
#include <limits>

namespace rc {

// Arrays of doubles over all points of a padded grid must be addressable.
constexpr std::int64_t most_points = std::numeric_limits<std::int64_t>::max() / 1024;

// Operator kind, boundary, points and cell size. Throws Error(ARGUMENT, SHAPE).
void check_grid(const rc_system& system);

}  // namespace rc
