// What must not change an answer, or must change it in a known way.
#include "invariance_tests.h"

int main(int argc, char** argv) {
  using namespace pairs;
  std::vector<Test> tests;
  for (const auto& part :
       {unit_tests(), symmetry_tests(), repetition_tests(), sequence_tests(), derivative_tests(), stop_tests()})
    tests.insert(tests.end(), part.begin(), part.end());
  return run_group("pairs.invariance", tests, argc, argv);
}
