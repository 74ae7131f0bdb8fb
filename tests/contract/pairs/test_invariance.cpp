// Changes of a problem that must not change the answer, or must change it in a known way. --part NAME [filter] runs one part,
// [filter] all of them.
#include <cstdio>
#include <cstring>

#include "invariance_tests.h"

int main(int argc, char** argv) {
  using namespace pairs;
  const struct {
    const char* name;
    std::vector<Test> (*tests)();
  } parts[] = {{"units", unit_tests},           {"repetitions", repetition_tests},
               {"sequences", sequence_tests},   {"stiffness", stiffness_tests},
               {"stops", stop_tests},           {"single_arrays", single_array_tests},
               {"arithmetic", arithmetic_tests}};
  const char* wanted = nullptr;
  if (argc > 2 && std::strcmp(argv[1], "--part") == 0) {
    wanted = argv[2];
    argc -= 2;
    argv += 2;
  }
  std::vector<Test> tests;
  for (const auto& part : parts)
    if (!wanted || std::strcmp(wanted, part.name) == 0) {
      const std::vector<Test> more = part.tests();
      tests.insert(tests.end(), more.begin(), more.end());
    }
  if (tests.empty()) return std::fprintf(stderr, "no part %s\n", wanted), 1;
  return run_group("pairs.invariance", tests, argc, argv);
}
