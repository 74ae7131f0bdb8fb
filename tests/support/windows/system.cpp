#include "support/system.h"

#include <malloc.h>
#include <windows.h>
// windows.h comes first
#include <aclapi.h>

#include <algorithm>
#include <cstdlib>
#include <thread>

namespace support {

const char* const device = "NUL";
const char* const device_refused = "unknown format";
const long machine_in_library = 0x84;  // where linkers put it
const char* const needed_by_all = "KERNEL32.dll";
const char* const folder_separator = ";";
const char* const writable_to_all = " can be written to by S-1-1-0; take that right away";
const char* const owned_by_another = " is owned by S-1-5-7, neither the system, its administrators nor the current user";

namespace {

// All rights to the one who owns it, and more to everybody.
void set_rights(const std::string& path, DWORD everybodys) {
  alignas(SID) unsigned char owner[SECURITY_MAX_SID_SIZE], everybody[SECURITY_MAX_SID_SIZE];
  DWORD bytes = sizeof owner;
  CreateWellKnownSid(WinCreatorOwnerSid, nullptr, owner, &bytes);
  bytes = sizeof everybody;
  CreateWellKnownSid(WinWorldSid, nullptr, everybody, &bytes);
  PSID user = nullptr;
  PSECURITY_DESCRIPTOR descriptor = nullptr;
  std::string name = path;
  GetNamedSecurityInfoA(name.data(), SE_FILE_OBJECT, OWNER_SECURITY_INFORMATION, &user, nullptr, nullptr, nullptr, &descriptor);
  EXPLICIT_ACCESSW entries[2] = {};
  for (EXPLICIT_ACCESSW& entry : entries) {
    entry.grfAccessMode = SET_ACCESS;
    entry.Trustee.TrusteeForm = TRUSTEE_IS_SID;
  }
  entries[0].grfAccessPermissions = FILE_ALL_ACCESS;
  entries[0].Trustee.ptstrName = static_cast<wchar_t*>(user ? user : static_cast<void*>(owner));
  entries[1].grfAccessPermissions = everybodys;
  entries[1].Trustee.ptstrName = reinterpret_cast<wchar_t*>(everybody);
  PACL rights = nullptr;
  if (SetEntriesInAclW(2, entries, nullptr, &rights) != ERROR_SUCCESS) std::abort();
  const SECURITY_INFORMATION what = DACL_SECURITY_INFORMATION | PROTECTED_DACL_SECURITY_INFORMATION;
  if (SetNamedSecurityInfoA(name.data(), SE_FILE_OBJECT, what, nullptr, nullptr, rights, nullptr) != ERROR_SUCCESS) std::abort();
  LocalFree(rights);
  LocalFree(descriptor);
}

}  // namespace

void let_everybody_write(const std::string& path) {
  set_rights(path, FILE_GENERIC_READ | FILE_GENERIC_WRITE | FILE_GENERIC_EXECUTE);
}

void let_owner_alone_write(const std::string& path) { set_rights(path, FILE_GENERIC_READ | FILE_GENERIC_EXECUTE); }

namespace {

bool is_anonymous(const std::string& path) {
  PSID user = nullptr;
  PSECURITY_DESCRIPTOR descriptor = nullptr;
  std::string name = path;
  if (GetNamedSecurityInfoA(name.data(), SE_FILE_OBJECT, OWNER_SECURITY_INFORMATION, &user, nullptr, nullptr, nullptr,
                            &descriptor) != ERROR_SUCCESS)
    return false;
  const bool anonymous = IsWellKnownSid(user, WinAnonymousSid);
  LocalFree(descriptor);
  return anonymous;
}

}  // namespace

// Windows lets none but its administrators do so. Wine starts programs of the system below, for which the file belongs to a user
// whom Wine calls anonymous.
bool give_away(const std::string& path) {
  if (!GetProcAddress(GetModuleHandleW(L"ntdll.dll"), "wine_get_version")) return false;
  std::string below = path.substr(2);
  std::replace(below.begin(), below.end(), '\\', '/');
  std::string line = "chown 12345 \"" + below + "\"";
  STARTUPINFOA start{};
  start.cb = sizeof start;
  PROCESS_INFORMATION process{};
  if (!CreateProcessA("Z:\\bin\\chown", line.data(), nullptr, nullptr, FALSE, 0, nullptr, nullptr, &start, &process))
    return false;
  if (process.hProcess) CloseHandle(process.hProcess);  // Wine has none for such a process: its work is looked for
  if (process.hThread) CloseHandle(process.hThread);
  for (int tries = 0; tries < 200; ++tries, Sleep(50))
    if (is_anonymous(path)) return true;
  return false;
}

// Relative to the folder that it is in, to a drive's current folder or to the drive; or as folders of other machines are called.
std::vector<std::string> other_names(const std::string& path) {
  std::string below = path.substr(2);
  std::replace(below.begin(), below.end(), '/', '\\');
  const std::string drive = path.substr(0, 2), name = below.substr(below.rfind('\\') + 1);
  const std::string shared = std::string("localhost\\") + path[0] + "$" + below;
  std::vector<std::string> names = {name, ".\\" + name, drive + name, below};
  for (const char* start : {"\\\\?\\", "\\\\.\\"}) names.push_back(start + drive + below);
  for (const char* start : {"\\\\", "\\\\?\\UNC\\"}) names.push_back(start + shared);
  for (std::size_t i = 0, n = names.size(); i < n; ++i) {
    std::string other = names[i];
    std::replace(other.begin(), other.end(), '\\', '/');
    if (other != names[i]) names.push_back(other);
  }
  return names;
}

bool make_pipe(const std::string&) { return false; }

void set_variable(const char* name, const char* value) { _putenv_s(name, value ? value : ""); }

void* aligned_memory(std::size_t alignment, std::size_t bytes) { return _aligned_malloc(bytes, alignment); }

void free_aligned(void* memory) { _aligned_free(memory); }

void limit_process(std::size_t bytes, unsigned seconds) {
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
  limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_PROCESS_MEMORY;
  limits.ProcessMemoryLimit = bytes;
  const HANDLE job = CreateJobObjectW(nullptr, nullptr);
  if (bytes > 0) SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof limits);
  AssignProcessToJobObject(job, GetCurrentProcess());
  std::thread([seconds] {
    Sleep(1000 * seconds);
    TerminateProcess(GetCurrentProcess(), 1);
  }).detach();
}

void limit_processor_time(unsigned) {}

}  // namespace support
