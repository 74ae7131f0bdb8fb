// Functions that each system's folder defines for the files of this folder.
#pragma once

#include <cstdint>
#include <string>

namespace rc_platform {

bool reach_disk(int descriptor);  // false with the cause in errno

// Why the system's loader should not see a plugin's file, as a whole sentence; "" if nothing speaks against it.
std::string flaw(int file, std::int64_t size, const std::string& path);

}  // namespace rc_platform
