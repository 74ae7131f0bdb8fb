// Text in other encodings than UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace rc::formats {

// The file without a byte order mark; text in UTF-16, which `converted` then holds, as UTF-8. Other files as they are. Throws an
// Error for UTF-32 and for UTF-16 with half a character.
std::string_view decoded(std::string_view file, std::string& converted);

}  // namespace rc::formats
