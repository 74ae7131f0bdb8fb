// Small generated problems.
#pragma once

#include "support/contact.h"

namespace pairs {

/** Random waves of a few wave numbers, periodic over the grid; highest point 0. */
Field rough_heights(std::int64_t nx, std::int64_t ny, unsigned seed);

/** A rough surface pressed in to half its mean gap, cells hx x hy, approach control. */
Problem rough_problem(std::int64_t nx, std::int64_t ny, std::int32_t boundary = RC_BOUNDARY_FREE, double hx = 1, double hy = 1);

/** The same, with noise on every cell, pressed in by a multiple of the mean gap. */
Problem rugged_problem(std::int64_t nx, std::int64_t ny, double depth, std::int32_t boundary = RC_BOUNDARY_FREE);

/** Gap r^2 / (2 radius) around (cx, cy), in cells of width h. */
Field paraboloid(std::int64_t nx, std::int64_t ny, double h, double cx, double cy, double radius);

}  // namespace pairs
