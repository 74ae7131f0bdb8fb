#include "study.h"

int main(int argc, char** argv) {
  std::vector<pairs::Test> tests = batch::against_single_tests();
  for (const pairs::Test& test : batch::ending_tests()) tests.push_back(test);
  return pairs::run_group("batch", tests, argc, argv);
}
