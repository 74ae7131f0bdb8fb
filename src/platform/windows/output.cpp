#include <cerrno>
#include <cstring>
#include <filesystem>

#include "platform/files.h"

namespace rc_platform {

namespace fs = std::filesystem;

QuietWrites::QuietWrites() = default;
QuietWrites::~QuietWrites() = default;

int own_descriptor(const fs::path&) { return -1; }
std::string stream_refusal(int) { return ""; }

std::string pour(std::FILE* from, const fs::path& path, int) {
  std::FILE* const to = _wfopen(path.c_str(), L"wbN");
  if (!to) return std::strerror(errno);
  char block[1 << 14];
  std::rewind(from);
  while (const std::size_t count = std::fread(block, 1, sizeof block, from)) std::fwrite(block, 1, count, to);
  const bool written = !std::ferror(from) && !std::ferror(to);
  return std::fclose(to) == 0 && written ? "" : std::strerror(errno);
}

}  // namespace rc_platform
