#include "whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "error.h"
#include "text.h"

namespace cli {

namespace fs = std::filesystem;

namespace {

// Unlinks the file unless it was renamed away.
class TemporaryFile {
 public:
  TemporaryFile(fs::path path, const fs::path& target) : path_(std::move(path)), target_(target) {
    const int descriptor = open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor >= 0) stream_ = fdopen(descriptor, "wb");
    if (!stream_) fail();
  }
  ~TemporaryFile() {
    if (stream_) std::fclose(stream_);
    if (!path_.empty()) unlink(path_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  std::FILE* stream() { return stream_; }

  void rename() {
    const bool written = !std::ferror(stream_) && std::fflush(stream_) == 0;
    const int error = errno;
    const bool closed = std::fclose(std::exchange(stream_, nullptr)) == 0;
    if (!written) errno = error;
    if (!written || !closed || std::rename(path_.c_str(), target_.c_str()) != 0) fail();
    path_.clear();
  }

 private:
  [[noreturn]] void fail() const { throw Error("cannot write " + in_quotes(target_.native()) + ": " + std::strerror(errno)); }

  fs::path path_;
  const fs::path& target_;
  std::FILE* stream_ = nullptr;
};

}  // namespace

void write_whole_file(const fs::path& path, const std::function<bool(std::FILE*)>& fill) {
  const std::string name = format(".%s.%d.tmp", path.filename().c_str(), static_cast<int>(getpid()));
  TemporaryFile file{path.parent_path() / name, path};
  if (fill(file.stream())) file.rename();
}

}  // namespace cli
