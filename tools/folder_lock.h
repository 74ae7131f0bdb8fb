// Lets one process at a time write to a folder: a lock on a file that names the process. The lock ends with the process, however
// that ends.
#pragma once

#include <filesystem>

namespace cli {

class FolderLock {
 public:
  // Throws an Error that names the process that holds the lock. If the file system has no locks, reports that and goes on.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

}  // namespace cli
