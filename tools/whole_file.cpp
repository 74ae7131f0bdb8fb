#include "whole_file.h"

#include <fcntl.h>
#include <sys/random.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <utility>

#include "error.h"
#include "text.h"

namespace cli {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t random_digits = 16;
constexpr std::string_view ending = ".tmp";

// The path of the temporary file that is being written.
std::atomic<const char*> unfinished{nullptr};
static_assert(std::atomic<const char*>::is_always_lock_free);

[[noreturn]] void fail(const fs::path& target) {
  throw Error("cannot write " + in_quotes(target.native()) + ": " + std::strerror(errno));
}

fs::path temporary_for(const fs::path& target) {
  std::uint64_t number = 0;
  if (getrandom(&number, sizeof number, 0) != sizeof number) fail(target);
  return target.parent_path() /
         format(".%s.%016llx%s", target.filename().c_str(), static_cast<unsigned long long>(number), ending.data());
}

// Unlinks the file unless it was renamed away.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target) : target_(target), path_(temporary_for(target)) {
    unfinished = path_.c_str();
    const int descriptor = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0) stream_ = fdopen(descriptor, "wb");
    if (stream_) return;
    const int error = errno;
    if (descriptor >= 0) {
      close(descriptor);
      unlink(path_.c_str());
    }
    unfinished = nullptr;
    errno = error;
    fail(target_);
  }
  ~TemporaryFile() {
    if (stream_) std::fclose(stream_);
    if (!renamed_) unlink(path_.c_str());
    unfinished = nullptr;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  std::FILE* stream() { return stream_; }

  void rename() {
    const bool written = !std::ferror(stream_) && std::fflush(stream_) == 0 && fsync(fileno(stream_)) == 0;
    const int error = errno;
    const bool closed = std::fclose(std::exchange(stream_, nullptr)) == 0;
    if (!written) errno = error;
    if (!written || !closed || std::rename(path_.c_str(), target_.c_str()) != 0) fail(target_);
    renamed_ = true;
  }

 private:
  const fs::path& target_;
  fs::path path_;
  std::FILE* stream_ = nullptr;
  bool renamed_ = false;
};

// Brings the new name to the disk, too. Some file systems cannot do that for folders.
void sync_folder(const fs::path& target) {
  const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;  // may be written to, not read
  const bool synced = fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS;
  const int error = errno;
  close(descriptor);
  errno = error;
  if (!synced) fail(target);
}

}  // namespace

void write_whole_file(const fs::path& path, const std::function<bool(std::FILE*)>& fill) {
  TemporaryFile file{path};
  if (!fill(file.stream())) return;
  file.rename();
  sync_folder(path);
}

void write_whole_file(const fs::path& path, const std::string& text) {
  write_whole_file(path, [&](std::FILE* file) {
    std::fwrite(text.data(), 1, text.size(), file);
    return true;
  });
}

void remove_unfinished_file() noexcept {
  if (const char* const path = unfinished) unlink(path);
}

std::string_view target_of_temporary(std::string_view name) {
  const std::size_t added = 1 + random_digits + ending.size();
  if (!name.starts_with('.') || !name.ends_with(ending) || name.size() <= 1 + added) return {};
  const std::string_view digits = name.substr(name.size() - ending.size() - random_digits, random_digits);
  const bool ours = digits.find_first_not_of("0123456789abcdef") == std::string_view::npos && name[name.size() - added] == '.';
  return ours ? name.substr(1, name.size() - 1 - added) : std::string_view{};
}

}  // namespace cli
