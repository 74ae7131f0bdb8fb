// The parts of pairs.invariance.
#pragma once

#include <vector>

#include "support/harness.h"

namespace pairs {

std::vector<Test> unit_tests();
std::vector<Test> repetition_tests();
std::vector<Test> sequence_tests();
std::vector<Test> stiffness_tests();
std::vector<Test> stop_tests();
std::vector<Test> single_array_tests();
std::vector<Test> arithmetic_tests();

}  // namespace pairs
