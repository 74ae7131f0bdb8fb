// The files that the command writes, see platform/output.h.
#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cli {

// `fill` writes the contents; if it throws or returns false, nothing is written. Throws an Error if writing fails.
void write_output(const std::filesystem::path& path, const std::function<bool(std::FILE*)>& fill);
void write_output(const std::filesystem::path& path, const std::string& text);

// Throws an Error, before work is done in vain, if an output cannot be written, or is read or written as another file.
// inputs: paths. outputs: options and their paths.
void check_outputs(const std::vector<std::string>& inputs, const std::vector<std::pair<std::string, std::string>>& outputs);

}  // namespace cli
