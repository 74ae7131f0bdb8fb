#pragma once

#include <vector>

#include "scenes.h"
#include "support/harness.h"

namespace accuracy {

std::vector<Test> statistics_tests();

}  // namespace accuracy
