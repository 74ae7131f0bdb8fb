// printf into a string.
#pragma once

#include <string>

namespace bench {

[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

}  // namespace bench
