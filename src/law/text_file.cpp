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
  const fs::path source = rc_platform::path_of(path);
  std::error_code none;
  if (!fs::is_regular_file(source, none)) fail(RC_ERR_ARGUMENT, path, ": cannot be read: there is no such file");
  std::ifstream file(source, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(file)), {});
  if (!file.is_open() || file.bad() || text.empty()) fail(RC_ERR_ARGUMENT, path, ": cannot be read, or is empty");
  return text;
}

void write_text(const char* path, const std::string& text) {
  fs::path target = rc_platform::path_of(path);
  std::error_code error;
  if (fs::is_symlink(target, error)) target = fs::canonical(target, error);
  if (fs::exists(target, error) && !fs::is_regular_file(target, error))
    fail(RC_ERR_ARGUMENT, path, ": cannot be written: it is there already, and no file");
  fs::path beside = target;
  beside += join(".new.", std::chrono::steady_clock::now().time_since_epoch().count());
  const auto write = [&] {
    std::ofstream file(beside, std::ios::binary);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    file.close();
    return file.good();
  };
  if (write()) {
    fs::rename(beside, target, error);
    if (!error) return;
  }
  fs::remove(beside, error);
  fail(RC_ERR_ARGUMENT, path, ": cannot be written");
}

}  // namespace rc
