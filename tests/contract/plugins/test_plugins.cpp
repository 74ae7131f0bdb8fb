// Plugins: those that must work, those that must be refused, and where they may lie.
#include "scratch.h"

int main(int argc, char** argv) {
  using namespace plugins;
  std::vector<pairs::Test> all;
  for (const auto part :
       {good_tests, refused_tests, place_tests, registration_tests, choice_tests, kernel_tests, promise_tests, many_liar_tests})
    for (pairs::Test& test : part()) all.push_back(std::move(test));
  return pairs::run_group("plugins", all, argc, argv);
}
