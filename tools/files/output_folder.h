// The folder of --out. One run at a time writes to it, and a file in it is either whole or not there.
#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "platform/files.h"

namespace cli {

class OutputFolder {
 public:
  // Creates the folder if it is missing. Throws if it cannot be written to, or if another run is writing to it.
  explicit OutputFolder(const std::filesystem::path& path);
  // Removes the folders created if nothing was put into them.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  // `fill` writes the contents; if it throws or returns false, the file is not made.
  void write(const std::string& name, const std::function<bool(std::FILE*)>& fill);

  // Throws if that name in the folder is of anything but a regular file: to open a pipe may take for ever.
  void refuse_special(const std::string& name) const;
  // The whole contents of a file in the folder; "" if there is none. Throws as refuse_special() does.
  std::string read(const std::string& name) const;
  std::vector<std::string> names() const;
  std::filesystem::path path(const std::string& name) const { return path_ / name; }
  void remove(const std::string& name);

 private:
  void lock();

  std::filesystem::path path_;
  std::vector<std::filesystem::path> created_;
  // On a file that names the process. It ends with the process, however that ends.
  std::optional<rc_platform::LockFile> lock_;
};

}  // namespace cli
