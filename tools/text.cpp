#include "text.h"

#include <cstdio>

namespace cli {

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

}  // namespace cli
