#include "platform/output.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <system_error>
#include <utility>

namespace rc_platform {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t random_digits = 16;
constexpr std::string_view unfinished_ending = ".tmp";
constexpr std::size_t longest_stem = 200;  // of a temporary name; file systems allow 255

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

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

// A new name in the folder of the target; "" with the cause in errno.
fs::path temporary_for(const fs::path& target) {
  std::uint64_t number = 0;
  if (!draw_random(number)) return {};
  std::string ending = ".";
  for (int shift = 60; shift >= 0; shift -= 4) ending += "0123456789abcdef"[(number >> shift) & 15];
  fs::path name = fs::path(".");
  name += target.filename().native().substr(0, longest_stem);
  name += ending.append(unfinished_ending);
  return target.parent_path() / name;
}

std::string cause() { return std::strerror(errno); }

// Why a regular file cannot be made or replaced.
std::string refusal_of(const fs::path& file, bool present) {
  std::error_code error;
  if (present && !may_write(file)) return cause();
  if (!fs::is_directory(folder_of(file), error)) return "its folder is missing";
  return may_write_into(folder_of(file)) ? "" : "its folder: " + cause();
}

}  // namespace

std::string_view special_kind(fs::file_type type) {
  switch (type) {
    case fs::file_type::directory:
      return "a folder";
    case fs::file_type::character:
      return "a device";
    case fs::file_type::block:
      return "a block device";
    case fs::file_type::fifo:
      return "a pipe";
    case fs::file_type::socket:
      return "a socket";
    case fs::file_type::unknown:
      return "no file of a known kind";
    default:
      return "";
  }
}

Target target_of(const fs::path& path) {
  constexpr int most_links = 40;
  Target target{path};
  std::error_code error;
  for (int links = 0;; ++links) {
    target.descriptor = own_descriptor(target.file);
    target.streamed = target.descriptor >= 0;
    if (target.streamed || !fs::is_symlink(target.file, error)) break;
    const fs::path next = fs::read_symlink(target.file, error);
    if (!error && links == most_links) error = std::make_error_code(std::errc::too_many_symbolic_link_levels);
    if (error) return {path, -1, false, error.message()};
    target.file = target.file.parent_path() / next;
  }
  if (target.streamed) {
    target.refusal = stream_refusal(target.descriptor);
    return target;
  }
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::none) {
    target.refusal = error.message();
  } else if (status.type() == fs::file_type::directory || !target.file.has_filename()) {
    target.refusal = "it is a folder, give the name of a file";
  } else if (status.type() == fs::file_type::block || status.type() == fs::file_type::socket) {
    target.refusal = std::string("it is ") + std::string(special_kind(status.type())) + ", give a file";
  } else if (fs::exists(status) && status.type() != fs::file_type::regular) {
    target.file = path;
    target.streamed = true;
    if (!may_write(path)) target.refusal = cause();
  } else {
    target.refusal = refusal_of(target.file, fs::exists(status));
  }
  return target;
}

Output::Output(const fs::path& path) : target_(target_of(path)), failure_(target_.refusal) {
  if (!failure_.empty()) return;
  if (target_.streamed) {
    stream_ = create_unnamed();
  } else if (temporary_ = temporary_for(target_.file); !temporary_.empty()) {
    place_ = take_place(temporary_);
    stream_ = create_like(temporary_, target_.file);
  }
  if (stream_) return;
  failure_ = cause();
  forget_temporary();
}

Output::~Output() {
  if (stream_) std::fclose(stream_);
  if (!temporary_.empty()) remove_file(temporary_.c_str());
  forget_temporary();
}

void Output::forget_temporary() {
  if (place_) *place_ = nullptr;
  place_ = nullptr;
  temporary_.clear();
}

void Output::finish() {
  const bool filled = !std::ferror(stream_) && (target_.streamed ? std::fflush(stream_) == 0 : bring_to_disk(stream_));
  if (!filled) {
    failure_ = errno ? cause() : "the disk took a part of it";
  } else if (target_.streamed) {
    failure_ = pour(stream_, target_.file, target_.descriptor);
  }
  const bool closed = std::fclose(std::exchange(stream_, nullptr)) == 0;
  if (!failure_.empty() || target_.streamed) return;
  if (!closed || !rename_over(temporary_, target_.file)) {
    failure_ = cause();
    return;
  }
  forget_temporary();
  if (!bring_folder_to_disk(folder_of(target_.file))) failure_ = cause();
}

std::string write_output(const fs::path& path, const std::function<bool(std::FILE*)>& fill) {
  Output output{path};
  if (output.failure().empty() && fill(output.stream())) output.finish();
  return output.failure();
}

std::string write_output(const fs::path& path, std::string_view contents) {
  return write_output(path, [&](std::FILE* file) {
    std::fwrite(contents.data(), 1, contents.size(), file);
    return true;
  });
}

void remove_unfinished_outputs() noexcept {
  for (const Unfinished& place : unfinished)
    if (const auto* const path = place.load()) remove_file(path);
}

std::string_view target_of_temporary(std::string_view name) {
  const std::size_t added = 1 + random_digits + unfinished_ending.size();
  if (!name.starts_with('.') || !name.ends_with(unfinished_ending) || name.size() <= 1 + added) return {};
  const std::string_view digits = name.substr(name.size() - unfinished_ending.size() - random_digits, random_digits);
  const bool ours = digits.find_first_not_of("0123456789abcdef") == std::string_view::npos && name[name.size() - added] == '.';
  return ours ? name.substr(1, name.size() - 1 - added) : std::string_view{};
}

}  // namespace rc_platform
