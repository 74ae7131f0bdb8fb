// The parts of pairs.analytic.
#pragma once

#include <numbers>
#include <vector>

#include "support/harness.h"

namespace pairs {

inline constexpr double pi = std::numbers::pi;

std::vector<Test> periodic_analytic_tests();

}  // namespace pairs
