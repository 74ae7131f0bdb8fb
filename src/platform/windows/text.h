// This system's text is UTF-16; the library's is UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace rc_platform {

std::wstring to_wide(std::string_view text);
std::string to_utf8(std::wstring_view text);
std::string error_text(unsigned long error);  // the system's sentence for GetLastError()

}  // namespace rc_platform
