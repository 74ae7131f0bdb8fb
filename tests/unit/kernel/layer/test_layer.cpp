// The kernel "layer".
#include "layer.h"

int main() {
  std::vector<CMUnitTest> all;
  for (const auto* part : {&layer::value_tests, &layer::solve_tests}) all.insert(all.end(), part->begin(), part->end());
  return _cmocka_run_group_tests("layer", all.data(), all.size(), nullptr, nullptr);
}
