// A file that is either whole or not there: it is written under a temporary name in the same folder, brought to the disk and then
// renamed. The temporary one goes whenever writing fails.
#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace cli {

// `fill` writes the contents; if it throws or returns false, the file is not made. What fails on the way to the disk is an Error.
void write_whole_file(const std::filesystem::path& path, const std::function<bool(std::FILE*)>& fill);
void write_whole_file(const std::filesystem::path& path, const std::string& text);

// For a process that a signal ends: removes the temporary file that is being written. May be called by a signal's handler.
void remove_unfinished_file() noexcept;

// The name of the file that a temporary one was to become; "" if it is not the name of a temporary file.
std::string_view target_of_temporary(std::string_view name);

}  // namespace cli
