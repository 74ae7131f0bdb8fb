// Files that are there whole or not at all, and folders that one process writes to. Failures leave their cause in errno.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace rc_platform {

// The path of a text in UTF-8. The standard library's own conversion uses another encoding if paths are not made of bytes.
inline std::filesystem::path path_of(std::string_view text) {
  return std::u8string_view(reinterpret_cast<const char8_t*>(text.data()), text.size());
}

std::FILE* open_to_read(const std::filesystem::path& path);  // not inherited by programs that are started
std::FILE* create_unnamed();                                 // to write and read, gone when it is closed
// A new file to write, with owner and permissions of another if that is there. Fails if there is one of its name.
std::FILE* create_like(const std::filesystem::path& path, const std::filesystem::path& other);

bool bring_to_disk(std::FILE* file);
bool bring_folder_to_disk(const std::filesystem::path& folder);  // true where a file system cannot do that for folders
bool rename_over(const std::filesystem::path& from, const std::filesystem::path& to);
void remove_file(const std::filesystem::path::value_type* path) noexcept;  // signal handlers may call it

bool may_write_into(const std::filesystem::path& folder);
bool may_write(const std::filesystem::path& file);
bool draw_random(std::uint64_t& number);
std::uint64_t size_of(std::FILE* file);

// The number of the open stream of this process that the path names, as /dev/fd/3 does; -1: it names none.
int own_descriptor(const std::filesystem::path& path);
std::string stream_refusal(int descriptor);  // why nothing can be written to this open stream; "" if it can

// Copies a file from its beginning to an open stream of this process, or (descriptor -1) to a device or pipe. Returns why that
// failed, or "".
std::string pour(std::FILE* from, const std::filesystem::path& to, int descriptor);

// While it lives, a full disk, a limit of file sizes or a reader that has gone only makes writing fail: SIGXFSZ and SIGPIPE do
// not reach this thread. Windows has neither.
class QuietWrites {
 public:
  QuietWrites();
  ~QuietWrites();
  QuietWrites(const QuietWrites&) = delete;
  QuietWrites& operator=(const QuietWrites&) = delete;

 private:
  [[maybe_unused]] bool blocked_[2] = {};  // by the caller
};

// A file that one process at a time holds, and that goes with it.
class LockFile {
 public:
  enum class State { held, held_by_another, not_supported, failed };

  explicit LockFile(std::filesystem::path path);
  ~LockFile();
  LockFile(const LockFile&) = delete;
  LockFile& operator=(const LockFile&) = delete;

  State state() const { return state_; }
  const std::string& holder() const { return holder_; }  // the other's process number; "" if it is not known

 private:
  std::filesystem::path path_;
  std::intptr_t file_ = -1;
  State state_ = State::failed;
  std::string holder_;
};

}  // namespace rc_platform
