#pragma once

#include <vector>

#include "support/harness.h"

namespace paths {

std::vector<pairs::Test> against_steps_tests();
std::vector<pairs::Test> output_tests();
std::vector<pairs::Test> restored_tests();
std::vector<pairs::Test> stop_tests();
std::vector<pairs::Test> level_tests();

}  // namespace paths
