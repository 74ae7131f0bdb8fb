#include "path_tests.h"

int main(int argc, char** argv) {
  std::vector<pairs::Test> tests = paths::against_steps_tests();
  for (const auto& more : {paths::output_tests(), paths::restored_tests(), paths::stop_tests(), paths::level_tests()})
    tests.insert(tests.end(), more.begin(), more.end());
  return pairs::run_group("paths", tests, argc, argv);
}
