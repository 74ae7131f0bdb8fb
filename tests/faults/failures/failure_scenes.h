// Small problems on which methods fail.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "support/contact.h"

namespace failures {

using namespace pairs;

// Bemporad & Paggi (2015), Example 1: side x side unit cells, every one a candidate, penetrations uniform on (0, 1). Spacing
// 2: a masked cell between each two.
Problem example_one(std::int64_t side, std::int64_t spacing, std::uint64_t seed);

// A paraboloid pressed in over a contact radius of about a third of n cells.
Problem hertz_problem(std::int64_t n);
// Midpoint displacement, approach half the height of the highest point above the mean plane; 2^levels points a side.
Problem midpoint_problem(std::int64_t levels, std::uint64_t seed);

// Well-posed problems that strain double precision, by name: near-full contact, one point, spikes, offsets, flatness, aspect,
// kernel.
std::vector<std::pair<std::string, Problem>> strained_problems(std::int64_t n);

}  // namespace failures
