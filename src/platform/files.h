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
std::FILE* create_new(const std::filesystem::path& path);    // to write; fails if there is one already
std::FILE* create_unnamed();                                 // to write and read, gone when it is closed

bool bring_to_disk(std::FILE* file);
bool bring_folder_to_disk(const std::filesystem::path& folder);  // true where a file system cannot do that for folders
bool rename_over(const std::filesystem::path& from, const std::filesystem::path& to);
void remove_file(const std::filesystem::path::value_type* path) noexcept;  // signal handlers may call it

bool may_write_into(const std::filesystem::path& folder);
bool draw_random(std::uint64_t& number);
std::uint64_t size_of(std::FILE* file);

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
