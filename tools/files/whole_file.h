// A file that is either whole or not there. It is written under a temporary name in the same folder, brought to the disk and then
// renamed. If writing fails, the temporary file is removed.
#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace cli {

// `fill` writes the contents; if it throws or returns false, the file is not made. Throws an Error if the disk fails.
void write_whole_file(const std::filesystem::path& path, const std::function<bool(std::FILE*)>& fill);
void write_whole_file(const std::filesystem::path& path, const std::string& text);

// A new name in the folder of the target, under which it is written before it is renamed.
std::filesystem::path temporary_for(const std::filesystem::path& target);

// Removes the temporary file that is being written, for a process that a signal ends. A signal handler may call it.
void remove_unfinished_file() noexcept;

// The name of the file that a temporary one was to become; "" if it is not the name of a temporary file.
std::string_view target_of_temporary(std::string_view name);

}  // namespace cli
