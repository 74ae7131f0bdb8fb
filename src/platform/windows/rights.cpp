#include "platform/windows/rights.h"

#include <sddl.h>

#include <algorithm>
#include <initializer_list>

#include "platform/windows/text.h"

namespace rc_platform {

namespace {

std::string name_of(PSID user) {
  wchar_t* text = nullptr;
  if (!ConvertSidToStringSidW(user, &text)) return "unknown";
  std::string name = to_utf8(text);
  LocalFree(text);
  return name;
}

bool is_well_known(PSID user, std::initializer_list<WELL_KNOWN_SID_TYPE> kinds) {
  return std::any_of(kinds.begin(), kinds.end(), [user](WELL_KNOWN_SID_TYPE kind) { return IsWellKnownSid(user, kind); });
}

// TrustedInstaller, who owns what Windows itself brings.
bool installs_windows(PSID user) { return name_of(user) == "S-1-5-80-956008885-3418522649-1831038044-1853292631-2271478464"; }

}  // namespace

std::string distrust(const std::string& path, const FileRights& rights, PSID user) {
  const auto trusted = [user](PSID somebody) {
    return is_well_known(somebody, {WinLocalSystemSid, WinBuiltinAdministratorsSid, WinCreatorOwnerSid}) ||
           installs_windows(somebody) || (user && EqualSid(somebody, user));
  };
  if (!rights.owner || !trusted(rights.owner))
    return "plugin refused: " + path + " is owned by " + (rights.owner ? name_of(rights.owner) : "nobody") +
           ", neither the system, its administrators nor the current user";
  if (!rights.list) return "plugin refused: " + path + " can be written to by everybody; take that right away";
  constexpr DWORD writes = FILE_WRITE_DATA | FILE_APPEND_DATA | WRITE_DAC | WRITE_OWNER | GENERIC_WRITE | GENERIC_ALL;
  for (DWORD i = 0; i < rights.list->AceCount; ++i) {
    void* entry = nullptr;
    if (!GetAce(rights.list, i, &entry)) continue;
    const auto& allowed = *static_cast<const ACCESS_ALLOWED_ACE*>(entry);
    const BYTE kind = allowed.Header.AceType;
    const bool allows = kind == ACCESS_ALLOWED_ACE_TYPE || kind == ACCESS_ALLOWED_CALLBACK_ACE_TYPE;  // of the same layout
    const bool inherited_only = (allowed.Header.AceFlags & INHERIT_ONLY_ACE) != 0;
    const auto somebody = const_cast<DWORD*>(&allowed.SidStart);
    if (allows && !inherited_only && (allowed.Mask & writes) != 0 && !trusted(somebody))
      return "plugin refused: " + path + " can be written to by " + name_of(somebody) + "; take that right away";
  }
  return {};
}

}  // namespace rc_platform
