// Greedy elimination on draws of Example 1 of Bemporad & Paggi (2015).
#pragma once

#include <cstdint>
#include <string>

#include "child.h"

namespace bench {

// How many of the first draws of example_one() greedy solves wrongly, with Wilson's 95 % interval, and how wrong; every answer is
// compared with that of nnls. Throws where nnls is not certified.
Json greedy_on_draws(const std::string& kernel, std::int64_t side, std::int64_t spacing, std::int64_t draws);

}  // namespace bench
