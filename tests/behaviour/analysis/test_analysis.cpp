#include "maps.h"

int main(int argc, char** argv) {
  std::vector<pairs::Test> tests = analysis::area_tests();
  for (const auto& more : {analysis::patch_tests(), analysis::histogram_tests(), analysis::crossing_tests()})
    tests.insert(tests.end(), more.begin(), more.end());
  return pairs::run_group("analysis", tests, argc, argv);
}
