// Whom Windows may let own a plugin's file and write to it, from what it would say of one.
#include <windows.h>

#include "platform/windows/rights.h"
// windows.h comes first
#include <sddl.h>

#include "support/cmocka.hpp"

namespace {

constexpr const wchar_t* me = L"S-1-5-21-1-2-3-1001";
constexpr const char* path = "C:/plugins/rcb_toy.dll";

// What is said of a file whose owner and rights the text has, in Windows' language for them (SDDL), to the user `me`.
std::string said_of(const std::wstring& text) {
  PSECURITY_DESCRIPTOR descriptor = nullptr;
  PSID user = nullptr;
  assert_true(ConvertStringSidToSidW(me, &user));
  assert_true(ConvertStringSecurityDescriptorToSecurityDescriptorW(text.c_str(), SDDL_REVISION_1, &descriptor, nullptr));
  rc_platform::FileRights rights;
  BOOL present = FALSE, by_default = FALSE;
  assert_true(GetSecurityDescriptorOwner(descriptor, &rights.owner, &by_default));
  assert_true(GetSecurityDescriptorDacl(descriptor, &present, &rights.list, &by_default));
  const std::string said = rc_platform::distrust(path, rights, user);
  LocalFree(descriptor);
  LocalFree(user);
  return said;
}

// Windows' abbreviations: SY the system, BA its administrators, WD everybody, BU users; FA all rights, FR to read, FW to write.
std::wstring mine(const std::wstring& entries) { return std::wstring(L"O:") + me + L"D:" + entries; }

void assert_trusted(const std::wstring& text) { assert_string_equal(said_of(text).c_str(), ""); }

void assert_writable_by(const std::wstring& text, const std::string& who) {
  assert_string_equal(
      said_of(text).c_str(),
      ("plugin refused: " + std::string(path) + " can be written to by " + who + "; take that right away").c_str());
}

void the_user_the_system_and_its_administrators_may_own_and_write(void**) {
  const std::wstring entries = std::wstring(L"(A;;FA;;;SY)(A;;FA;;;BA)(A;;FA;;;CO)(A;;FA;;;") + me + L")(A;;FR;;;WD)";
  assert_trusted(mine(entries));
  assert_trusted(L"O:SYD:" + entries);
  assert_trusted(L"O:BAD:" + entries);
  assert_trusted(L"O:S-1-5-80-956008885-3418522649-1831038044-1853292631-2271478464D:" + entries);
}

void others_may_not_own(void**) {
  for (const wchar_t* owner : {L"S-1-5-21-1-2-3-1002", L"S-1-5-32-545", L"S-1-1-0", L"S-1-5-7", L"S-1-5-80-1-2-3-4-5"}) {
    const std::wstring wide = owner;
    const std::string name(wide.begin(), wide.end());
    assert_string_equal(said_of(L"O:" + wide + L"D:(A;;FA;;;SY)").c_str(),
                        ("plugin refused: " + std::string(path) + " is owned by " + name +
                         ", neither the system, its administrators nor the current user")
                            .c_str());
  }
  assert_string_equal(said_of(L"D:(A;;FA;;;SY)").c_str(),
                      "plugin refused: C:/plugins/rcb_toy.dll is owned by nobody, neither the system, its administrators nor the "
                      "current user");
}

// To write, to append, to change the rights or the owner; each alone suffices to change what is loaded.
void others_may_not_write(void**) {
  assert_writable_by(mine(L"(A;;FA;;;WD)"), "S-1-1-0");
  for (const wchar_t* right : {L"FW", L"0x2", L"0x4", L"WD", L"WO", L"GA", L"GW"})
    assert_writable_by(mine(std::wstring(L"(A;;FA;;;SY)(A;;") + right + L";;;S-1-5-32-545)"), "S-1-5-32-545");
  assert_writable_by(mine(L"(A;;FW;;;S-1-5-21-1-2-3-1002)"), "S-1-5-21-1-2-3-1002");
}

void others_may_read_and_what_is_denied_or_for_files_to_come_is_no_right(void**) {
  assert_trusted(mine(L"(A;;FR;;;WD)(A;;FX;;;S-1-5-32-545)"));
  assert_trusted(mine(L"(D;;FA;;;WD)(A;;FR;;;WD)"));
  assert_trusted(mine(L"(A;OICIIO;FA;;;WD)"));
}

void a_file_without_a_list_of_rights_is_everybodys(void**) {
  PSID user = nullptr;
  assert_true(ConvertStringSidToSidW(me, &user));
  assert_string_equal(rc_platform::distrust(path, {user, nullptr}, user).c_str(),
                      "plugin refused: C:/plugins/rcb_toy.dll can be written to by everybody; take that right away");
  assert_true(rc_platform::distrust(path, {user, nullptr}, nullptr).find(" is owned by ") != std::string::npos);
  LocalFree(user);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(the_user_the_system_and_its_administrators_may_own_and_write),
      cmocka_unit_test(others_may_not_own),
      cmocka_unit_test(others_may_not_write),
      cmocka_unit_test(others_may_read_and_what_is_denied_or_for_files_to_come_is_no_right),
      cmocka_unit_test(a_file_without_a_list_of_rights_is_everybodys),
  };
  return cmocka_run_group_tests_name("rights", tests, nullptr, nullptr);
}
