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

using Unfinished = std::atomic<const fs::path::value_type*>;
static_assert(Unfinished::is_always_lock_free);

// The paths of the temporary files that are being written.
Unfinished unfinished[2];

// A place for a path; null: more files are being written at a time than there are places.
Unfinished* take_place(const fs::path& path) {
  for (Unfinished& place : unfinished) {
    const fs::path::value_type* none = nullptr;
    if (place.compare_exchange_strong(none, path.c_str())) return &place;
  }
  return nullptr;
}

[[noreturn]] void fail(const fs::path& target) {
  throw Error("cannot write ", in_quotes(target.string()), ": ", std::strerror(errno));
}

// Unlinks the file unless it was renamed away.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target)
      : target_(target), path_(temporary_for(target)), place_(take_place(path_)), stream_(rc_platform::create_new(path_)) {
    if (stream_) return;
    const int error = errno;
    if (place_) *place_ = nullptr;
    errno = error;
    fail(target_);
  }
  ~TemporaryFile() {
    if (stream_) std::fclose(stream_);
    if (!renamed_) rc_platform::remove_file(path_.c_str());
    if (place_) *place_ = nullptr;
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
  Unfinished* place_;
  std::FILE* stream_;
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
  for (const Unfinished& place : unfinished)
    if (const auto* const path = place.load()) rc_platform::remove_file(path);
}

std::string_view target_of_temporary(std::string_view name) {
  const std::size_t added = 1 + random_digits + unfinished_ending.size();
  if (!name.starts_with('.') || !name.ends_with(unfinished_ending) || name.size() <= 1 + added) return {};
  const std::string_view digits = name.substr(name.size() - unfinished_ending.size() - random_digits, random_digits);
  const bool ours = digits.find_first_not_of("0123456789abcdef") == std::string_view::npos && name[name.size() - added] == '.';
  return ours ? name.substr(1, name.size() - 1 - added) : std::string_view{};
}

}  // namespace cli
