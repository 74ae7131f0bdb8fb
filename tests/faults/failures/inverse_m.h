// When the greedy method (Bemporad & Paggi 2015, Algorithm 1) is exact for every surface.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace failures {

// Greedy elimination solves H p - u >= 0, p >= 0, p (H p - u) = 0 for every u if and only if H^-1 has no positive entry off its
// diagonal; it is then Chandrasekaran's method (1970) for such matrices. Where (H^-1)_jk > 0 take u with (H^-1 u)_k = -1,
// (H^-1 u)_j = -(H^-1)_jk / (2 (H^-1)_kk) and the other entries large: greedy drops j, which carries pressure.
//
// The largest (H^-1)_jk, j != k, over the smallest (H^-1)_kk, for side x side cells whose centres are `spacing` cells apart. Not
// positive: greedy is exact for every u on this set and, as the property is inherited, on each of its subsets.
double largest_inverse_coupling(const std::string& kernel, std::int64_t side, std::int64_t spacing);

// The penetrations u of the construction above for the largest coupling: greedy fails on them. Empty where there is none.
std::vector<double> greedy_counterexample(const std::string& kernel, std::int64_t side);

}  // namespace failures
