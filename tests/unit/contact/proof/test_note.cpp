// Remarks in a note are whole, and those without room are counted.
#include <string>
#include <vector>

#include "contact/proof/result.h"
#include "support/cmocka.hpp"

namespace {

void remarks_are_whole(void**) {
  const std::string ten(10, 'a'), long_one(60, 'b');
  assert_string_equal(rc::note_from({}, 60).c_str(), "");
  assert_string_equal(rc::note_from({ten, ten}, 22).c_str(), (ten + "; " + ten).c_str());
  assert_string_equal(rc::note_from({ten, ten}, 32).c_str(), (ten + "; " + ten).c_str());
  assert_string_equal(rc::note_from({ten, long_one, ten}, 60).c_str(), (ten + "; " + ten + "; 1 more remark").c_str());
  assert_string_equal(rc::note_from({long_one, long_one}, 59).c_str(), "2 more remarks");
}

void a_note_never_exceeds_its_room(void**) {
  for (std::size_t room = 20; room < 80; ++room)
    for (std::size_t count = 0; count < 12; ++count) {
      std::vector<std::string> remarks;
      for (std::size_t i = 0; i < count; ++i) remarks.emplace_back(1 + (7 * i + room) % 22, 'c');
      assert_true(rc::note_from(remarks, room).size() <= room);
    }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(remarks_are_whole), cmocka_unit_test(a_note_never_exceeds_its_room)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
