#include "standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "text.h"

namespace cli {

void open_standard_streams() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(number, F_GETFD) != -1 || errno != EBADF) continue;
    // The lowest free number is taken, which is this one; as in the C library's start of privileged programs, nothing can be read
    // from the input or written to the others.
    const int opened = open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    if (opened != number && opened >= 0) close(opened);
  }
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
