#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include "platform/files.h"
#include "platform/posix/system.h"

namespace rc_platform {

namespace fs = std::filesystem;

namespace {

constexpr int quiet_signals[] = {SIGPIPE, SIGXFSZ};

sigset_t set_of(int number) {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, number);
  return set;
}

bool write_all(int descriptor, const char* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t written = write(descriptor, bytes, size);
    if (written < 0 && errno == EAGAIN) {
      pollfd room{descriptor, POLLOUT, 0};
      poll(&room, 1, -1);
    } else if (written < 0 && errno != EINTR) {
      return false;
    }
    bytes += written > 0 ? written : 0;
    size -= written > 0 ? static_cast<std::size_t>(written) : 0;
  }
  return true;
}

// Opens without waiting for a pipe's reader; writing waits.
int open_stream(const fs::path& path) {
  const int descriptor = open(path.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (descriptor >= 0) fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
  return descriptor;
}

// Gives a new file the owner and group of another, and returns its permissions. Only the superuser gives files away, and a user
// only to a group of his own: the members of the group that it then has get the rights that others have.
mode_t like(int descriptor, const struct stat& other) {
  const mode_t mode = other.st_mode & 0777;
  if (fchown(descriptor, other.st_uid, other.st_gid) == 0 || fchown(descriptor, static_cast<uid_t>(-1), other.st_gid) == 0)
    return mode;
  return (mode & 0707) | (mode & 0007) << 3;
}

}  // namespace

QuietWrites::QuietWrites() {
  for (int k = 0; k < 2; ++k) {
    const sigset_t signal = set_of(quiet_signals[k]);
    sigset_t before;
    pthread_sigmask(SIG_BLOCK, &signal, &before);
    blocked_[k] = sigismember(&before, quiet_signals[k]) == 1;
  }
}

// Takes the signals that writing has raised.
QuietWrites::~QuietWrites() {
  const int error = errno;
  for (int k = 0; k < 2; ++k) {
    if (blocked_[k]) continue;
    const sigset_t signal = set_of(quiet_signals[k]);
    take_pending(quiet_signals[k]);
    pthread_sigmask(SIG_UNBLOCK, &signal, nullptr);
  }
  errno = error;
}

int own_descriptor(const fs::path& path) {
  const std::string name = path.filename().native();
  if (name.empty() || name.size() > 9 || name.find_first_not_of("0123456789") != std::string::npos) return -1;
  for (const char* const folder : {"/proc/self/fd", "/dev/fd"}) {
    std::error_code error;
    if (fs::equivalent(path.parent_path(), folder, error)) return std::atoi(name.c_str());
  }
  return -1;
}

std::string stream_refusal(int descriptor) {
  const int flags = fcntl(descriptor, F_GETFL);
  if (flags < 0) return std::strerror(errno);
  return (flags & O_ACCMODE) == O_RDONLY ? "this stream is open for reading only" : "";
}

bool may_write(const fs::path& file) { return faccessat(AT_FDCWD, file.c_str(), W_OK, AT_EACCESS) == 0; }

std::FILE* create_like(const fs::path& path, const fs::path& other) {
  struct stat info {};
  const bool present = stat(other.c_str(), &info) == 0;
  const int descriptor = open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, present ? 0600 : 0666);
  if (descriptor < 0) return nullptr;
  std::FILE* const stream = !present || fchmod(descriptor, like(descriptor, info)) == 0 ? fdopen(descriptor, "w+b") : nullptr;
  if (stream) return stream;
  const int error = errno;
  close(descriptor);
  unlink(path.c_str());
  errno = error;
  return nullptr;
}

std::string pour(std::FILE* from, const fs::path& to, int stream) {
  const int descriptor = stream >= 0 ? fcntl(stream, F_DUPFD_CLOEXEC, 3) : open_stream(to);
  if (descriptor < 0) {
    const std::string failure = std::strerror(errno);
    std::error_code none;
    return errno == ENXIO && fs::is_fifo(to, none) ? "nobody reads this pipe, start its reader first" : failure;
  }
  char block[1 << 16];
  bool written = true;
  std::rewind(from);
  while (written) {
    const std::size_t count = std::fread(block, 1, sizeof block, from);
    if (count == 0) break;
    written = write_all(descriptor, block, count);
  }
  const int error = errno;
  const bool closed = close(descriptor) == 0;
  if (!written) errno = error;
  return written && closed && !std::ferror(from) ? "" : std::strerror(errno);
}

}  // namespace rc_platform
