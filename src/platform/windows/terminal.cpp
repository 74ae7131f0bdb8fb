#include "platform/terminal.h"

#include <fcntl.h>
#include <io.h>
#include <windows.h>
// windows.h comes first
#include <shellapi.h>

#include <atomic>
#include <csignal>
#include <memory>

#include "platform/windows/text.h"

namespace rc_platform {

namespace {

std::atomic<void (*)(int)> asked_to_end{nullptr};

// The C library forgets a handler before it calls it.
void call(int number) {
  std::signal(number, call);
  asked_to_end.load()(number);
}

}  // namespace

std::vector<std::string> arguments(int argc, char** argv) {
  int count = 0;
  const std::unique_ptr<wchar_t*, void (*)(wchar_t**)> words{CommandLineToArgvW(GetCommandLineW(), &count),
                                                             [](wchar_t** p) { LocalFree(p); }};
  if (!words || count != argc) return {argv, argv + argc};
  std::vector<std::string> list;
  for (int i = 0; i < count; ++i) list.push_back(to_utf8(words.get()[i]));
  return list;
}

void open_standard_streams() {
  SetConsoleOutputCP(CP_UTF8);
  for (const int number : {0, 1, 2}) {
    if (_get_osfhandle(number) >= 0) {
      if (number > 0) _setmode(number, _O_BINARY);  // lines end as they do on other systems
      continue;
    }
    const int opened = _open("NUL", number == 0 ? _O_WRONLY : _O_RDONLY);
    if (opened != number && opened >= 0) {
      _dup2(opened, number);
      _close(opened);
    }
  }
}

bool is_terminal(std::FILE* stream) { return _isatty(_fileno(stream)) != 0; }

std::size_t terminal_width() {
  CONSOLE_SCREEN_BUFFER_INFO info{};
  return GetConsoleScreenBufferInfo(GetStdHandle(STD_ERROR_HANDLE), &info) && info.dwSize.X > 0
             ? static_cast<std::size_t>(info.dwSize.X)
             : 80;
}

void when_asked_to_end(void (*handler)(int)) {
  asked_to_end = handler;
  for (const int number : {SIGINT, SIGTERM, SIGBREAK})
    if (std::signal(number, call) == SIG_IGN) std::signal(number, SIG_IGN);
}

void end_by(int number) {
  std::signal(number, SIG_DFL);
  std::raise(number);
}

}  // namespace rc_platform
