// Problems for option accuracy, and the same problem on a coarser grid.
#pragma once

#include <cstdint>

#include "support/contact.h"

namespace accuracy {

using namespace pairs;

/** Random midpoint displacement, 2^levels points a side, pressed in to a fraction of the mean gap. */
Problem midpoint_problem(std::int64_t levels, double hurst, std::uint64_t seed, double depth);

/** Random waves of the seed, periodic or not. */
Problem waves_problem(std::int64_t n, std::int32_t boundary, unsigned seed, double depth);

/** Means over blocks of factor x factor points; the sides are multiples of it. */
Problem block_means(const Problem& problem, std::int64_t factor);

Settings goal(double error, const char* of, const char* tol = "1e-9");

}  // namespace accuracy
