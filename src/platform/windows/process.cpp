#include "platform/process.h"

#include <io.h>
#include <windows.h>

#include <iterator>

#include "platform/windows/text.h"

namespace rc_platform {

namespace {

HANDLE inheritable(std::FILE* file) {
  const auto handle = reinterpret_cast<HANDLE>(_get_osfhandle(_fileno(file)));
  SetHandleInformation(handle, HANDLE_FLAG_INHERIT, HANDLE_FLAG_INHERIT);
  return handle;
}

}  // namespace

std::string own_program() {
  wchar_t path[32768];
  const DWORD length = GetModuleFileNameW(nullptr, path, std::size(path));
  return length < std::size(path) ? to_utf8({path, length}) : std::string();
}

Ended run(const std::string& program, const std::vector<std::string>& arguments, std::FILE* input, std::FILE* output,
          std::FILE* errors) {
  std::string line = '"' + program + '"';
  for (const std::string& word : arguments) line += " \"" + word + '"';
  std::wstring words = to_wide(line);
  STARTUPINFOW start{};
  start.cb = sizeof start;
  start.dwFlags = STARTF_USESTDHANDLES;
  start.hStdInput = inheritable(input);
  start.hStdOutput = inheritable(output);
  start.hStdError = inheritable(errors);
  PROCESS_INFORMATION child{};
  if (!CreateProcessW(nullptr, words.data(), nullptr, nullptr, TRUE, CREATE_NEW_PROCESS_GROUP | CREATE_NO_WINDOW, nullptr,
                      nullptr, &start, &child)) {
    const DWORD error = GetLastError();
    return {-1, error == ERROR_FILE_NOT_FOUND, error_text(error)};
  }
  DWORD code = 0;
  const bool ended = WaitForSingleObject(child.hProcess, INFINITE) == WAIT_OBJECT_0 && GetExitCodeProcess(child.hProcess, &code);
  CloseHandle(child.hThread);
  CloseHandle(child.hProcess);
  return ended ? Ended{static_cast<int>(code), false, ""} : Ended{-1, false, error_text(GetLastError())};
}

Ended become(const std::string& program, const std::vector<std::string>& arguments) {
  return run(program, arguments, stdin, stdout, stderr);
}

}  // namespace rc_platform
