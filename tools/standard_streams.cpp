#include "standard_streams.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "text.h"

namespace cli {

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
