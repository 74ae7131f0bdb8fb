// Plugins: those that must work, those that must be refused, and where they may lie.
#include "scratch.h"

int main() {
  std::vector<CMUnitTest> all;
  for (const auto* part : {&plugins::good_tests, &plugins::refused_tests, &plugins::place_tests, &plugins::registration_tests,
                           &plugins::choice_tests, &plugins::kernel_tests, &plugins::promise_tests, &plugins::many_liar_tests})
    all.insert(all.end(), part->begin(), part->end());
  return _cmocka_run_group_tests("plugins", all.data(), all.size(), nullptr, nullptr);
}
