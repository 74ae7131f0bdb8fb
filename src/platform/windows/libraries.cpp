#include "platform/libraries.h"

#include <windows.h>
// windows.h comes first
#include <aclapi.h>

#include <cstdint>
#include <cstring>
#include <memory>

#include "platform/windows/rights.h"
#include "platform/windows/text.h"

// The linker's name for the beginning of the file that this code is in.
extern "C" const IMAGE_DOS_HEADER __ImageBase;

namespace rc_platform {

const std::string_view library_suffix = ".dll", own_library = "libroughcontact-";
const char path_separator = ';';

namespace {

struct FreeLocal {
  void operator()(void* p) const { LocalFree(p); }
};
template <class T> using Local = std::unique_ptr<T, FreeLocal>;

struct CloseAnyHandle {
  void operator()(void* handle) const { CloseHandle(handle); }
};
using Handle = std::unique_ptr<void, CloseAnyHandle>;

// The identifier of the user who runs this process.
struct CurrentUser {
  alignas(TOKEN_USER) unsigned char buffer[sizeof(TOKEN_USER) + SECURITY_MAX_SID_SIZE]{};

  PSID read() {
    HANDLE opened = nullptr;
    if (!OpenProcessToken(GetCurrentProcess(), TOKEN_QUERY, &opened)) return nullptr;
    const Handle token(opened);
    DWORD length = 0;
    if (!GetTokenInformation(opened, TokenUser, buffer, sizeof buffer, &length)) return nullptr;
    return reinterpret_cast<const TOKEN_USER*>(buffer)->User.Sid;
  }
};

// The reason to refuse a file that others can write to; "" if only its owner, the system and its administrators can.
std::string distrust(const std::string& path) {
  FileRights rights;
  PSECURITY_DESCRIPTOR descriptor = nullptr;
  std::wstring wide = to_wide(path);
  const DWORD error = GetNamedSecurityInfoW(wide.data(), SE_FILE_OBJECT, OWNER_SECURITY_INFORMATION | DACL_SECURITY_INFORMATION,
                                            &rights.owner, nullptr, &rights.list, nullptr, &descriptor);
  if (error != ERROR_SUCCESS) return "plugin refused: the owner of " + path + " cannot be read: " + error_text(error);
  const Local<void> owned(descriptor);
  CurrentUser user;
  return distrust(path, rights, user.read());
}

const IMAGE_NT_HEADERS& own_header() {
  return *reinterpret_cast<const IMAGE_NT_HEADERS*>(reinterpret_cast<const char*>(&__ImageBase) + __ImageBase.e_lfanew);
}

// The parts that the headers of a library promise must be in the file.
std::string flaw(HANDLE file, const std::string& path) {
  LARGE_INTEGER size{};
  GetFileSizeEx(file, &size);
  const auto available = static_cast<std::uint64_t>(size.QuadPart);
  const auto read = [file](std::uint64_t at, void* into, DWORD bytes) {
    OVERLAPPED place{};
    place.Offset = static_cast<DWORD>(at);
    place.OffsetHigh = static_cast<DWORD>(at >> 32);
    DWORD done = 0;
    return ReadFile(file, into, bytes, &done, &place) && done == bytes;
  };
  IMAGE_DOS_HEADER dos{};
  IMAGE_NT_HEADERS header{};
  if (!read(0, &dos, sizeof dos) || dos.e_magic != IMAGE_DOS_SIGNATURE || dos.e_lfanew < 0 ||
      !read(static_cast<std::uint64_t>(dos.e_lfanew), &header, sizeof header) || header.Signature != IMAGE_NT_SIGNATURE ||
      header.FileHeader.Machine != own_header().FileHeader.Machine ||
      header.OptionalHeader.Magic != IMAGE_NT_OPTIONAL_HDR_MAGIC || (header.FileHeader.Characteristics & IMAGE_FILE_DLL) == 0)
    return "plugin refused: " + path + " is not a shared object of this machine";
  std::uint64_t at = static_cast<std::uint64_t>(dos.e_lfanew) + offsetof(IMAGE_NT_HEADERS, OptionalHeader) +
                     header.FileHeader.SizeOfOptionalHeader;
  for (int i = 0; i < header.FileHeader.NumberOfSections; ++i, at += sizeof(IMAGE_SECTION_HEADER)) {
    IMAGE_SECTION_HEADER section{};
    if (!read(at, &section, sizeof section) || section.PointerToRawData + std::uint64_t{section.SizeOfRawData} > available)
      return "plugin refused: " + path + " is incomplete, it has only " + std::to_string(available) + " bytes; copy it again";
  }
  return {};
}

// Why a plugin's file is not opened; "" if nothing speaks against it.
std::string obstacle(const std::string& path) {
  const std::string directory = path.substr(0, path.find_last_of("/\\"));
  if (!exists(directory)) return "plugin directory " + directory + ": " + error_text(GetLastError());
  if (std::string reason = distrust(directory); !reason.empty()) return reason;
  const DWORD attributes = GetFileAttributesW(to_wide(path).c_str());
  if (attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0)
    return "plugin refused: " + path + " is not a regular file";
  const HANDLE opened = CreateFileW(to_wide(path).c_str(), GENERIC_READ, FILE_SHARE_READ, nullptr, OPEN_EXISTING, 0, nullptr);
  if (opened == INVALID_HANDLE_VALUE) return "plugin " + path + " cannot be opened: " + error_text(GetLastError());
  const Handle file(opened);
  if (GetFileType(opened) != FILE_TYPE_DISK) return "plugin refused: " + path + " is not a regular file";
  if (std::string reason = distrust(path); !reason.empty()) return reason;
  return flaw(opened, path);
}

}  // namespace

bool is_absolute(std::string_view path) {
  const auto slash = [](char c) { return c == '/' || c == '\\'; };
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return path.size() > 2 && letter(path[0]) && path[1] == ':' && slash(path[2]);
}

// From the system, in UTF-8: getenv() loses letters that the current code page lacks.
const char* trusted_environment(const char* name) {
  thread_local std::string text;
  std::wstring value(GetEnvironmentVariableW(to_wide(name).c_str(), nullptr, 0), L'\0');
  value.resize(GetEnvironmentVariableW(to_wide(name).c_str(), value.data(), static_cast<DWORD>(value.size())));
  if (value.empty()) return nullptr;
  text = to_utf8(value);
  return text.c_str();
}

std::string file_of(const void* code) {
  HMODULE module = nullptr;
  wchar_t path[32768];
  if (!GetModuleHandleExW(GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_PIN,
                          static_cast<const wchar_t*>(code), &module))
    return {};
  const DWORD length = GetModuleFileNameW(module, path, std::size(path));
  return length > 0 && length < std::size(path) ? to_utf8(path) : std::string();
}

bool exists(const std::string& path) { return GetFileAttributesW(to_wide(path).c_str()) != INVALID_FILE_ATTRIBUTES; }

std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  WIN32_FIND_DATAW entry{};
  const HANDLE search = FindFirstFileW(to_wide(folder + "\\*").c_str(), &entry);
  if (search == INVALID_HANDLE_VALUE) return names;
  try {
    do names.push_back(to_utf8(entry.cFileName));
    while (FindNextFileW(search, &entry));
  } catch (...) {
    FindClose(search);
    throw;
  }
  FindClose(search);
  return names;
}

bool loads_plugins() { return true; }

OpenedPlugin open_plugin(const std::string& path) {
  OpenedPlugin opened{nullptr, obstacle(path)};
  if (!opened.error.empty()) return opened;
  const HMODULE code =
      LoadLibraryExW(to_wide(path).c_str(), nullptr, LOAD_LIBRARY_SEARCH_DEFAULT_DIRS | LOAD_LIBRARY_SEARCH_DLL_LOAD_DIR);
  if (!code) {
    opened.error = "plugin " + path + " cannot be loaded: " + error_text(GetLastError());
    return opened;
  }
  opened.code = reinterpret_cast<void*>(code);
  return opened;
}

void* symbol_of(void* code, const char* name) {
  return reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(code), name));
}

}  // namespace rc_platform
