// Text for people: printf into a string, and texts of a file that stay one line.
#pragma once

#include <string>
#include <string_view>

namespace rc::formats {

[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...);

// Text from a file or an argument, safe to put into a message: control characters become '?', long text is cut.
std::string in_quotes(std::string_view text);

// ASCII's letters; other bytes stay.
std::string lower_case(std::string_view text);

std::string_view trimmed(std::string_view text);

}  // namespace rc::formats
