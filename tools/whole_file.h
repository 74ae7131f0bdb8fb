// A file that is either whole or not there: it is written under a temporary name in the same folder and then renamed, and the
// temporary one goes whenever writing fails.
#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>

namespace cli {

// `fill` writes the contents; if it throws or returns false, the file is not made.
void write_whole_file(const std::filesystem::path& path, const std::function<bool(std::FILE*)>& fill);

}  // namespace cli
