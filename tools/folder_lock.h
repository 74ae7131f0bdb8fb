// One writer at a time in a folder: a lock that ends with the process, however that ends, on a file that names the process.
#pragma once

#include <filesystem>

namespace cli {

class FolderLock {
 public:
  // Throws an Error that names the process that holds it. Where the file system knows no locks, reports it and goes on.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

}  // namespace cli
