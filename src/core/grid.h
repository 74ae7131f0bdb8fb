// The grid of a system, checked.
#pragma once

#include <roughcontact/roughcontact.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace rc {

// Arrays of complex numbers over all points of a padded grid must be addressable, with room for more where pointers have 64 bits.
constexpr std::int64_t most_points = std::numeric_limits<std::ptrdiff_t>::max() / (sizeof(void*) == 8 ? 1024 : 64);

// "ix=17, iy=4" of a point in rows of nx, for messages.
std::string place(std::int64_t point, std::int64_t nx);

// Operator kind, boundary, points and cell size. Throws Error(ARGUMENT, SHAPE).
void check_grid(const rc_system& system);

// That the machine has the memory for one number at each of these points of the grid. Throws Error(MEMORY).
void check_memory(const rc_system& system, std::int64_t points);

}  // namespace rc
