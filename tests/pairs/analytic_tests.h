// The parts of pairs.analytic.
#pragma once

#include <vector>

#include "harness.h"

namespace pairs {

std::vector<Test> periodic_analytic_tests();

}  // namespace pairs
