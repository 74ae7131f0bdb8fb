#include "honesty_tests.h"

int main(int argc, char** argv) {
  std::vector<pairs::Test> tests;
  for (const auto& part :
       {pairs::near_the_mean_plane(), pairs::far_datums(), pairs::remarks(), pairs::not_definite(), pairs::first_causes()})
    tests.insert(tests.end(), part.begin(), part.end());
  return pairs::run_group("honesty", tests, argc, argv);
}
