#include "direct_tests.h"

namespace direct {

std::vector<Language> languages() {
  std::vector<Language> result = {{"C", matrix_from_c, cascade_from_c}};
#ifdef RC_TEST_FORTRAN
  result.push_back({"Fortran", matrix_from_fortran, cascade_from_fortran});
#endif
  return result;
}

}  // namespace direct

int main(int argc, char** argv) {
  std::vector<pairs::Test> tests = direct::matrix_tests();
  const std::vector<pairs::Test> more = direct::cascade_tests();
  tests.insert(tests.end(), more.begin(), more.end());
  return pairs::run_group("direct", tests, argc, argv);
}
