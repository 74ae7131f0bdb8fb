// test_batch [coarse | others]: a part of the tests, which take about as long each. Without a word, or with the name of
// a test: all, or that one.
#include <map>
#include <string>

#include "study.h"

namespace {

std::string part_of(const std::string& test) { return test.ends_with("/coarse_grids_start_anew") ? "coarse" : "others"; }

}  // namespace

int main(int argc, char** argv) {
  std::map<std::string, std::vector<pairs::Test>> parts;
  std::vector<pairs::Test> tests;
  for (const auto& some : {batch::against_single_tests(), batch::ending_tests()})
    for (const pairs::Test& test : some) {
      tests.push_back(test);
      parts[part_of(test.name)].push_back(test);
    }
  if (argc > 1 && parts.contains(argv[1])) return pairs::run_group("batch", parts[argv[1]], 1, argv);
  return pairs::run_group("batch", tests, argc, argv);
}
