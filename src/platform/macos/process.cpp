#include "platform/process.h"

#include <mach-o/dyld.h>

#include <climits>
#include <cstdint>
#include <cstdlib>

std::string rc_platform::own_program() {
  char path[PATH_MAX] = "", real[PATH_MAX] = "";
  std::uint32_t size = sizeof path;
  return _NSGetExecutablePath(path, &size) == 0 && realpath(path, real) ? real : std::string();
}
