#include "platform/files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>  // has getentropy on some systems, unistd.h on others
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "platform/posix/system.h"

namespace rc_platform {

namespace fs = std::filesystem;

namespace {

// Its last holder may have removed the file between our opening and locking it.
bool still_there(int descriptor, const fs::path& path) {
  struct stat locked {
  }, named{};
  return fstat(descriptor, &locked) == 0 && stat(path.c_str(), &named) == 0 && same_file(locked, named);
}

std::string number_in(int descriptor) {
  char text[32] = {};
  const ssize_t length = pread(descriptor, text, sizeof text - 1, 0);
  const std::string all(text, length > 0 ? static_cast<std::size_t>(length) : 0);
  return all.substr(0, all.find_last_not_of(" \n") + 1);
}

// Null if there is no memory for it; the file is closed then.
std::FILE* stream_of(int descriptor, const char* mode) {
  std::FILE* const stream = fdopen(descriptor, mode);
  if (stream) return stream;
  const int error = errno;
  close(descriptor);
  errno = error;
  return nullptr;
}

}  // namespace

std::FILE* open_to_read(const fs::path& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  return descriptor < 0 ? nullptr : stream_of(descriptor, "rb");
}

std::FILE* create_unnamed() { return std::tmpfile(); }

bool bring_to_disk(std::FILE* file) { return std::fflush(file) == 0 && reach_disk(fileno(file)); }

bool bring_folder_to_disk(const fs::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return true;  // may be written to, not read
  const bool synced = fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS;
  const int error = errno;
  close(descriptor);
  errno = error;
  return synced;
}

bool rename_over(const fs::path& from, const fs::path& to) { return std::rename(from.c_str(), to.c_str()) == 0; }

void remove_file(const char* path) noexcept { unlink(path); }

bool may_write_into(const fs::path& folder) { return access(folder.c_str(), W_OK | X_OK) == 0; }

bool draw_random(std::uint64_t& number) { return getentropy(&number, sizeof number) == 0; }

std::uint64_t size_of(std::FILE* file) {
  struct stat info {};
  return fstat(fileno(file), &info) == 0 ? static_cast<std::uint64_t>(info.st_size) : 0;
}

LockFile::LockFile(fs::path path) : path_(std::move(path)) {
  for (;;) {
    const int descriptor = open(path_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor < 0) return;
    const bool locked = flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    const int error = errno;
    if (locked && still_there(descriptor, path_)) {
      file_ = descriptor;
      state_ = State::held;
      const std::string process = std::to_string(getpid()) + "\n";
      if (ftruncate(descriptor, 0) != 0 || write(descriptor, process.data(), process.size()) < 0) return;  // then unnamed
      return;
    }
    const bool other = !locked && error == EWOULDBLOCK, unable = !locked && error != EWOULDBLOCK && error != EINTR;
    if (other) holder_ = number_in(descriptor);
    close(descriptor);
    errno = error;
    if (other || unable) {
      state_ = other ? State::held_by_another : State::not_supported;
      return;
    }
  }
}

LockFile::~LockFile() {
  if (state_ != State::held) return;
  unlink(path_.c_str());
  close(static_cast<int>(file_));
}

}  // namespace rc_platform
