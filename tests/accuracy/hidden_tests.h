#pragma once

#include <vector>

#include "pairs/harness.h"
#include "scenes.h"

namespace accuracy {

std::vector<Test> hidden_tests();

}  // namespace accuracy
