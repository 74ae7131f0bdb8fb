#include "files/whole_file.h"

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <utility>

#include "formats/error.h"
#include "platform/files.h"
#include "text.h"

namespace cli {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t random_digits = 16;
constexpr std::string_view unfinished_ending = ".tmp";

// The path of the temporary file that is being written.
std::atomic<const fs::path::value_type*> unfinished{nullptr};
static_assert(std::atomic<const fs::path::value_type*>::is_always_lock_free);

[[noreturn]] void fail(const fs::path& target) {
  throw Error("cannot write ", in_quotes(target.string()), ": ", std::strerror(errno));
}

// Unlinks the file unless it was renamed away.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target) : target_(target), path_(temporary_for(target)) {
    unfinished = path_.c_str();
    stream_ = rc_platform::create_new(path_);
    if (stream_) return;
    const int error = errno;
    unfinished = nullptr;
    errno = error;
    fail(target_);
  }
  ~TemporaryFile() {
    if (stream_) std::fclose(stream_);
    if (!renamed_) rc_platform::remove_file(path_.c_str());
    unfinished = nullptr;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  std::FILE* stream() { return stream_; }

  void rename() {
    const bool written = !std::ferror(stream_) && rc_platform::bring_to_disk(stream_);
    const int error = errno;
    const bool closed = std::fclose(std::exchange(stream_, nullptr)) == 0;
    if (!written) errno = error;
    if (!written || !closed || !rc_platform::rename_over(path_, target_)) fail(target_);
    renamed_ = true;
  }

 private:
  const fs::path& target_;
  fs::path path_;
  std::FILE* stream_ = nullptr;
  bool renamed_ = false;
};

}  // namespace

fs::path temporary_for(const fs::path& target) {
  std::uint64_t number = 0;
  if (!rc_platform::draw_random(number)) fail(target);
  return target.parent_path() / rc_platform::path_of(format(".%s.%016llx%s", target.filename().string().c_str(),
                                                            static_cast<unsigned long long>(number), unfinished_ending.data()));
}

void write_whole_file(const fs::path& path, const std::function<bool(std::FILE*)>& fill) {
  TemporaryFile file{path};
  if (!fill(file.stream())) return;
  file.rename();
  if (!rc_platform::bring_folder_to_disk(path.has_parent_path() ? path.parent_path() : ".")) fail(path);
}

void write_whole_file(const fs::path& path, const std::string& text) {
  write_whole_file(path, [&](std::FILE* file) {
    std::fwrite(text.data(), 1, text.size(), file);
    return true;
  });
}

void remove_unfinished_file() noexcept {
  if (const auto* const path = unfinished.load()) rc_platform::remove_file(path);
}

std::string_view target_of_temporary(std::string_view name) {
  const std::size_t added = 1 + random_digits + unfinished_ending.size();
  if (!name.starts_with('.') || !name.ends_with(unfinished_ending) || name.size() <= 1 + added) return {};
  const std::string_view digits = name.substr(name.size() - unfinished_ending.size() - random_digits, random_digits);
  const bool ours = digits.find_first_not_of("0123456789abcdef") == std::string_view::npos && name[name.size() - added] == '.';
  return ours ? name.substr(1, name.size() - 1 - added) : std::string_view{};
}

}  // namespace cli
