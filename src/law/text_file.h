// Whole text files: read into memory; written under a temporary name and renamed, so that a file is complete or unchanged.
#pragma once

#include <string>

namespace rc {

// Throw Error(ARGUMENT) with the path; paths are UTF-8.
std::string read_text(const char* path);
void write_text(const char* path, const std::string& text);

}  // namespace rc
