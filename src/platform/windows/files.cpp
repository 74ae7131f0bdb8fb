#include "platform/files.h"

#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>
#include <windows.h>
// windows.h comes first
#include <ntsecapi.h>

#include <cerrno>
#include <cstdlib>
#include <utility>

namespace rc_platform {

namespace fs = std::filesystem;

namespace {

// The nearest of the C library's numbers, whose texts the command prints.
int number_of(DWORD error) {
  switch (error) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
      return ENOENT;
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS:
      return EEXIST;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
      return ENOSPC;
    case ERROR_ACCESS_DENIED:
    case ERROR_SHARING_VIOLATION:
      return EACCES;
    default:
      return EIO;
  }
}

HANDLE handle_of(std::FILE* file) { return reinterpret_cast<HANDLE>(_get_osfhandle(_fileno(file))); }

// A stream of the C library on a handle, which it closes.
std::FILE* stream_on(HANDLE handle, int flags, const char* mode) {
  if (handle == INVALID_HANDLE_VALUE) {
    errno = number_of(GetLastError());
    return nullptr;
  }
  const int descriptor = _open_osfhandle(reinterpret_cast<std::intptr_t>(handle), flags | _O_BINARY | _O_NOINHERIT);
  std::FILE* const stream = descriptor < 0 ? nullptr : _fdopen(descriptor, mode);
  if (stream) return stream;
  descriptor < 0 ? void(CloseHandle(handle)) : void(_close(descriptor));
  return nullptr;
}

}  // namespace

std::FILE* open_to_read(const fs::path& path) { return _wfopen(path.c_str(), L"rbN"); }

// Permissions are those of the folder.
std::FILE* create_like(const fs::path& path, const fs::path&) {
  return stream_on(CreateFileW(path.c_str(), GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_DELETE, nullptr,
                               CREATE_NEW, 0, nullptr),
                   _O_RDWR, "w+b");
}

std::FILE* create_unnamed() {
  wchar_t folder[MAX_PATH + 1], path[MAX_PATH + 1];
  if (GetTempPathW(MAX_PATH + 1, folder) == 0 || GetTempFileNameW(folder, L"rc", 0, path) == 0) {
    errno = number_of(GetLastError());
    return nullptr;
  }
  constexpr DWORD everybody = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
  return stream_on(CreateFileW(path, GENERIC_READ | GENERIC_WRITE, everybody, nullptr, CREATE_ALWAYS,
                               FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE, nullptr),
                   _O_RDWR, "w+b");
}

bool bring_to_disk(std::FILE* file) { return std::fflush(file) == 0 && _commit(_fileno(file)) == 0; }

// Names are part of what a rename writes through.
bool bring_folder_to_disk(const fs::path&) { return true; }

bool rename_over(const fs::path& from, const fs::path& to) {
  if (MoveFileExW(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH)) return true;
  errno = number_of(GetLastError());
  return false;
}

void remove_file(const wchar_t* path) noexcept { DeleteFileW(path); }

bool may_write_into(const fs::path& folder) {
  const HANDLE opened = CreateFileW(folder.c_str(), FILE_ADD_FILE, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                                    nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
  if (opened == INVALID_HANDLE_VALUE) errno = number_of(GetLastError());
  return opened != INVALID_HANDLE_VALUE && CloseHandle(opened);
}

bool may_write(const fs::path& file) { return _waccess(file.c_str(), 2) == 0; }

bool draw_random(std::uint64_t& number) { return RtlGenRandom(&number, sizeof number); }

std::uint64_t size_of(std::FILE* file) {
  LARGE_INTEGER size{};
  return GetFileSizeEx(handle_of(file), &size) ? static_cast<std::uint64_t>(size.QuadPart) : 0;
}

LockFile::LockFile(fs::path path) : path_(std::move(path)) {
  const HANDLE file = CreateFileW(path_.c_str(), GENERIC_WRITE | DELETE, FILE_SHARE_READ, nullptr, OPEN_ALWAYS,
                                  FILE_FLAG_DELETE_ON_CLOSE, nullptr);
  if (file != INVALID_HANDLE_VALUE) {
    file_ = reinterpret_cast<std::intptr_t>(file);
    state_ = State::held;
    const std::string process = std::to_string(GetCurrentProcessId()) + "\n";
    DWORD written = 0;
    SetEndOfFile(file);
    WriteFile(file, process.data(), static_cast<DWORD>(process.size()), &written, nullptr);
    return;
  }
  const DWORD error = GetLastError();
  errno = number_of(error);
  if (error != ERROR_SHARING_VIOLATION) return;
  state_ = State::held_by_another;
  constexpr DWORD everybody = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
  const HANDLE other = CreateFileW(path_.c_str(), GENERIC_READ, everybody, nullptr, OPEN_EXISTING, 0, nullptr);
  if (other == INVALID_HANDLE_VALUE) return;
  char text[32];
  DWORD length = 0;
  if (ReadFile(other, text, sizeof text, &length, nullptr)) holder_.assign(text, length);
  holder_.erase(holder_.find_last_not_of(" \n") + 1);
  CloseHandle(other);
}

LockFile::~LockFile() {
  if (state_ == State::held) CloseHandle(reinterpret_cast<HANDLE>(file_));
}

}  // namespace rc_platform
