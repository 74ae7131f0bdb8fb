#include "folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "error.h"
#include "text.h"

namespace cli {

namespace {

constexpr const char* lock_name = ".roughcontact.lock";

std::string holder(int descriptor) {
  char text[32] = {};
  const ssize_t length = pread(descriptor, text, sizeof text - 1, 0);
  return length > 0 ? "process " + std::string(trimmed(text)) : "another process";
}

// Its last holder may have removed the file between our opening and locking it.
bool still_there(int descriptor, const std::filesystem::path& path) {
  struct stat locked {
  }, named{};
  return fstat(descriptor, &locked) == 0 && stat(path.c_str(), &named) == 0 && locked.st_ino == named.st_ino &&
         locked.st_dev == named.st_dev;
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder) : path_(folder / lock_name) {
  const std::string where = "--out: folder " + in_quotes(folder.native());
  for (;;) {
    descriptor_ = open(path_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor_ < 0) throw Error(where + " cannot be locked: " + std::strerror(errno));
    const bool locked = flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
    const int error = errno;
    if (locked && still_there(descriptor_, path_)) break;
    const std::string other = locked || error != EWOULDBLOCK ? "" : holder(descriptor_);
    if (!locked && error != EWOULDBLOCK && error != EINTR) {
      report(format("%s cannot be locked (%s): see to it that no other run writes into it", where.c_str(), std::strerror(error)));
      return;
    }
    close(descriptor_);
    descriptor_ = -1;
    if (!other.empty())
      throw Error(format("%s is being written to by %s: wait for its end, or give another folder", where.c_str(), other.c_str()));
  }
  const std::string process = std::to_string(getpid()) + "\n";
  if (ftruncate(descriptor_, 0) != 0 || write(descriptor_, process.data(), process.size()) < 0) return;  // then unnamed
}

FolderLock::~FolderLock() {
  if (descriptor_ < 0) return;
  unlink(path_.c_str());
  close(descriptor_);
}

}  // namespace cli
