#include "topography_tests.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "support/cmocka.hpp"
#include "topography.h"

namespace {

class File {
 public:
  explicit File(const std::string& text) {
    const int descriptor = mkstemp(path_);
    assert_true(descriptor >= 0);
    assert_int_equal(write(descriptor, text.data(), text.size()), text.size());
    ::close(descriptor);
  }
  ~File() { std::remove(path_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  std::string path() const { return path_; }

 private:
  char path_[32] = "/tmp/topographyXXXXXX";
};

std::string refusal(const std::string& text) {
  const File file(text);
  try {
    read_topography(file.path());
  } catch (const std::runtime_error& failure) {
    return failure.what();
  }
  return "accepted";
}

void assert_contains(const std::string& text, const char* part) {
  if (text.find(part) == std::string::npos) fail_msg("\"%s\" is not in: %s", part, text.c_str());
}

}  // namespace

void reads_rows_with_and_without_a_last_semicolon(void**) {
  for (const char* text : {"1;2\n3;4\n", "1;2;\n3;4;\n", "1; 2\r\n 3.0 ;4e0\r\n\n", "+1;2\n3;+4"}) {
    const File file(text);
    const Topography map = read_topography(file.path());
    assert_int_equal(map.side, 2);
    assert_true((map.heights == std::vector<double>{1, 2, 3, 4}));
  }
  const File one("-1.25e-3");
  assert_true(read_topography(one.path()).heights.front() == -1.25e-3);
}

void refuses_files_with_line_and_reason(void**) {
  assert_contains(refusal(""), "no values");
  assert_contains(refusal("1;2\n3;four\n"), "line 2: value 2, \"four\"");
  assert_contains(refusal("1;2\n3;nan\n"), "not a finite number");
  assert_contains(refusal("1;;2\n"), "value 2, \"\"");
  assert_contains(refusal("1;2\n3\n"), "line 2: 1 values; the first line has 2");
  assert_contains(refusal("1;2\n"), "1 lines of 2 values; give a square map");
  assert_contains(refusal("1 2\n3 4\n"), "\"1 2\"");
  try {
    read_topography("/nowhere/at/all");
    fail_msg("a file that is not there was read");
  } catch (const std::runtime_error& failure) {
    assert_contains(failure.what(), "cannot be opened");
  }
}
