// The backend split through its vtable.
#include "scene.h"

int main() {
  std::vector<CMUnitTest> tests = split::product_tests;
  tests.insert(tests.end(), split::screen_tests.begin(), split::screen_tests.end());
  return _cmocka_run_group_tests("split", tests.data(), tests.size(), nullptr, nullptr);
}
