#include "law/text_file.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "core/error.h"
#include "platform/files.h"

namespace rc {

namespace fs = std::filesystem;

std::string read_text(const char* path) {
  std::ifstream file(rc_platform::path_of(path), std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(file)), {});
  if (!file.is_open() || file.bad() || text.empty()) fail(RC_ERR_ARGUMENT, path, ": cannot be read, or is empty");
  return text;
}

void write_text(const char* path, const std::string& text) {
  const fs::path target = rc_platform::path_of(path);
  fs::path beside = target;
  beside += join(".new.", std::chrono::steady_clock::now().time_since_epoch().count());
  const auto write = [&] {
    std::ofstream file(beside, std::ios::binary);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    file.close();
    return file.good();
  };
  std::error_code error;
  if (write())
    fs::rename(beside, target, error);
  else
    error = std::make_error_code(std::errc::io_error);
  if (!error) return;
  std::error_code ignored;
  fs::remove(beside, ignored);
  fail(RC_ERR_ARGUMENT, path, ": cannot be written");
}

}  // namespace rc
