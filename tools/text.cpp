#include "text.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace cli {

std::string right_aligned(const std::string& text, std::size_t width) {
  const auto follows = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; };
  const auto columns = text.size() - static_cast<std::size_t>(std::ranges::count_if(text, follows));
  return std::string(columns < width ? width - columns : 0, ' ') + text;
}

void report(std::string_view text) {
  char line[512];
  std::size_t length = 0;
  const auto put = [&](char c) {
    line[length++] = c;
    if (length < sizeof line && c != '\n') return;
    std::fwrite(line, 1, length, stderr);
    length = 0;
  };
  for (const char c : std::string_view(command_name)) put(c);
  for (const char c : std::string_view(": ")) put(c);
  for (const char c : text) put(static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c);
  put('\n');
}

bool finish_standard_output() {
  const bool failed_before = std::ferror(stdout) != 0;
  errno = 0;
  if (std::fflush(stdout) == 0 && !failed_before) return true;
  char text[200];
  std::snprintf(text, sizeof text, "cannot write to standard output: %s",
                errno ? std::strerror(errno) : "lines are missing there");
  report(text);
  return false;
}

}  // namespace cli
