#include "output_folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "error.h"
#include "text.h"

namespace cli {

namespace fs = std::filesystem;

namespace {

// Unlinks the file unless it was renamed away.
class TemporaryFile {
 public:
  explicit TemporaryFile(fs::path path) : path_(std::move(path)) {
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

  void rename_to(const fs::path& target) {
    const bool written = !std::ferror(stream_) && std::fflush(stream_) == 0;
    const int error = errno;
    const bool closed = std::fclose(std::exchange(stream_, nullptr)) == 0;
    if (!written) errno = error;
    if (!written || !closed || std::rename(path_.c_str(), target.c_str()) != 0) fail();
    path_.clear();
  }

 private:
  [[noreturn]] void fail() const { throw Error("cannot write " + in_quotes(path_.native()) + ": " + std::strerror(errno)); }

  fs::path path_;
  std::FILE* stream_ = nullptr;
};

}  // namespace

OutputFolder::OutputFolder(const fs::path& path) : path_(fs::absolute(path).lexically_normal()) {
  std::error_code error;
  for (fs::path missing = path_; !missing.empty() && !fs::exists(missing, error); missing = missing.parent_path()) {
    created_.push_back(missing);
  }
  fs::create_directories(path_, error);
  if (error) throw Error("--out: cannot create folder " + in_quotes(path.native()) + ": " + error.message());
  if (!fs::is_directory(path_)) throw Error("--out: " + in_quotes(path.native()) + " is not a folder");
  if (access(path_.c_str(), W_OK | X_OK) != 0) {
    throw Error("--out: folder " + in_quotes(path.native()) + " is not writable: " + std::strerror(errno));
  }
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;  // a folder that is not empty stays
  for (const auto& folder : created_) fs::remove(folder, ignored);
}

void OutputFolder::write(const std::string& name, const std::function<bool(std::FILE*)>& fill) {
  TemporaryFile file{path_ / ("." + name + "." + std::to_string(getpid()) + ".tmp")};
  if (fill(file.stream())) file.rename_to(path_ / name);
}

std::string OutputFolder::read(const std::string& name) const {
  std::ifstream stream{path_ / name, std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

void OutputFolder::remove(const std::string& name) {
  std::error_code ignored;  // only tidies up
  fs::remove(path_ / name, ignored);
}

}  // namespace cli
