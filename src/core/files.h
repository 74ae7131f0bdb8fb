// Files as bytes in memory. Failures are Error(ARGUMENT) with the path. Paths are UTF-8, or any bytes where the system allows
// them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rc {

// The contents of a regular file that begins with these bytes and has no more than `most`. Nothing is read of others.
std::string read_file(const char* path, std::string_view begins, std::uint64_t most);

// Whole or unchanged, see platform/output.h.
void write_file(const char* path, std::string_view contents);

}  // namespace rc
