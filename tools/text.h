// Text for people: printf into a string, and lines that stay one line.
#pragma once

#include <string>
#include <string_view>

namespace cli {

[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...);

// Text from a file or an argument, safe to put into a message: control characters become '?', long text is cut.
std::string in_quotes(std::string_view text);

// Writes "roughcontact: text" as exactly one line to standard error. Allocates nothing.
void report(std::string_view text);

std::string_view trimmed(std::string_view text);

}  // namespace cli
