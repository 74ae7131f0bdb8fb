// Lets one process at a time write to a folder: a lock on a file that names the process. The lock ends with the process, however
// that ends.
#pragma once

#include <filesystem>

#include "platform/files.h"

namespace cli {

class FolderLock {
 public:
  static constexpr const char* name = ".roughcontact.lock";  // of the file

  // Throws an Error that names the process that holds the lock. If the file system has no locks, reports that and goes on.
  explicit FolderLock(const std::filesystem::path& folder);

 private:
  rc_platform::LockFile file_;
};

}  // namespace cli
