#pragma once

#include <vector>

#include "scenes.h"
#include "support/harness.h"

namespace accuracy {

std::vector<Test> hidden_tests();

}  // namespace accuracy
