#pragma once

#include <string>
#include <vector>

#include "callers.h"
#include "support/harness.h"

namespace direct {

struct Language {
  std::string name;
  matrix_caller matrix;
  cascade_caller cascade;
};
std::vector<Language> languages();

std::vector<pairs::Test> matrix_tests();
std::vector<pairs::Test> cascade_tests();

}  // namespace direct
