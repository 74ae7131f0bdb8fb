// How many processor cores this process may keep busy.
#pragma once

#include <cstdint>
#include <string>

namespace rc_platform {

std::int64_t allowed_cores();  // that its threads may run on, >= 1

// Cores' worth of time that the groups of processes which this one belongs to may use together, rounded up; 0: no limit.
// root: the folder of the system's files; "" but for tests.
std::int64_t granted_cores(const std::string& root = "");

}  // namespace rc_platform
