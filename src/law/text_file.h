// Whole text files: read into memory; written beside and renamed, so that a file is there whole or as it was before.
#pragma once

#include <string>

namespace rc {

// Throw Error(ARGUMENT) with the path; paths are UTF-8.
std::string read_text(const char* path);
void write_text(const char* path, const std::string& text);

}  // namespace rc
