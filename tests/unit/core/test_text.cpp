// Texts of messages: how each kind of part is written.
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/text.h"
#include "support/cmocka.hpp"

namespace {

using namespace rc;

void check_text(const std::string& found, const char* expected) { assert_string_equal(found.c_str(), expected); }

void reals_have_up_to_12_digits(void**) {
  check_text(join(0.1, " ", 1.0, " ", -2.5e-30, " ", 1e100, " ", 123456789012345.0), "0.1 1 -2.5e-30 1e+100 1.23456789012e+14");
  check_text(join(1.0F / 3), "0.333333343267");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  check_text(join(infinity, " ", -infinity, " ", std::numeric_limits<double>::quiet_NaN()), "inf -inf nan");
}

void whole_numbers_are_exact(void**) {
  check_text(join(std::numeric_limits<std::int64_t>::min(), " ", std::numeric_limits<std::uint64_t>::max()),
             "-9223372036854775808 18446744073709551615");
  check_text(join(std::int32_t{-7}, " ", std::size_t{7}, " ", true), "-7 7 1");
}

void characters_stay_as_they_are(void**) {
  check_text(join("a", std::string("b"), std::string_view("c d").substr(2), 'e', ""), "abde");
  check_text(join(), "");
  check_text(join("name ", static_cast<const char*>(nullptr)), "name (null)");
}

void exact_texts_tell_neighbours_apart(void**) {
  const double next = std::nextafter(0.3, 1);
  assert_string_not_equal(exact(0.3).c_str(), exact(next).c_str());
  assert_true(parse_real(exact(next)) == next);
  check_text(in_digits(1234.5, 2), "1.2e+03");
}

void a_failure_carries_status_and_text(void**) {
  try {
    fail(RC_ERR_SHAPE, "nx = ", std::int64_t{0}, " must be >= 1");
  } catch (const Error& error) {
    assert_int_equal(error.code(), RC_ERR_SHAPE);
    assert_string_equal(error.what(), "nx = 0 must be >= 1");
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(reals_have_up_to_12_digits), cmocka_unit_test(whole_numbers_are_exact),
                              cmocka_unit_test(characters_stay_as_they_are), cmocka_unit_test(exact_texts_tell_neighbours_apart),
                              cmocka_unit_test(a_failure_carries_status_and_text)};
  return cmocka_run_group_tests_name("unit.text", tests, nullptr, nullptr);
}
