#include "platform/cores.h"

#include <algorithm>
#include <thread>

namespace rc_platform {

std::int64_t allowed_cores() { return std::max<std::int64_t>(1, std::thread::hardware_concurrency()); }

std::int64_t granted_cores(const std::string&) { return 0; }  // this system has no such limits

}  // namespace rc_platform
