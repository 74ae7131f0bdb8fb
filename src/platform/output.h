// How every output is written. A regular file is written under a temporary name in its folder, brought to the disk and renamed:
// it is whole or unchanged, and keeps its permissions. Through a link its target is replaced. A device, a pipe or an open stream
// (/dev/stdout) gets the finished bytes. Folders, block devices, sockets and pipes that nobody reads are refused.
#pragma once

#include <atomic>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "platform/files.h"

namespace rc_platform {

// The name of a kind of file for messages: "a folder", "a pipe"; "" for a regular file and for a path without a file.
std::string_view special_kind(std::filesystem::file_type type);

// The kind of file that an output of this name writes to. Nothing is opened or changed.
struct Target {
  std::filesystem::path file;  // the end of the links
  int descriptor = -1;         // the open stream of this process that the path names; -1: none
  bool streamed = false;       // it gets bytes, and is not replaced
  std::string refusal{};       // why nothing can be written; "" if it can
};
Target target_of(const std::filesystem::path& path);

// An output in the making: its bytes are in a regular file, which is removed unless finish() succeeds.
class Output {
 public:
  explicit Output(const std::filesystem::path& path);
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  const std::string& failure() const { return failure_; }  // why nothing is written; "" so far
  std::FILE* stream() const { return stream_; }            // null after a failure
  const std::filesystem::path& temporary() const { return temporary_; }
  void finish();

 private:
  void forget_temporary();

  QuietWrites quiet_;
  Target target_;
  std::filesystem::path temporary_;  // "" if there is none
  std::atomic<const std::filesystem::path::value_type*>* place_ = nullptr;
  std::FILE* stream_ = nullptr;
  std::string failure_;
};

// `fill` writes the contents; if it throws or returns false, nothing is written. Returns why writing failed, or "".
std::string write_output(const std::filesystem::path& path, const std::function<bool(std::FILE*)>& fill);
std::string write_output(const std::filesystem::path& path, std::string_view contents);

// Removes the temporary files that are being written, for a process that a signal ends. A signal handler may call it.
void remove_unfinished_outputs() noexcept;

// The name of the file that a temporary one was to become; "" if it is not the name of a temporary file.
std::string_view target_of_temporary(std::string_view name);

}  // namespace rc_platform
