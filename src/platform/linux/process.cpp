#include "platform/process.h"

#include <filesystem>
#include <system_error>

std::string rc_platform::own_program() {
  std::error_code unknown;
  return std::filesystem::read_symlink("/proc/self/exe", unknown);
}
