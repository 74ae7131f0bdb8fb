#include "batch/study.h"

int main(int argc, char** argv) {
  std::vector<pairs::Test> tests = batch::against_single_tests();
  for (const auto& more : {batch::refusal_tests(), batch::ending_tests()}) tests.insert(tests.end(), more.begin(), more.end());
  return pairs::run_group("batch", tests, argc, argv);
}
