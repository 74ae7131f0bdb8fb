// Lines of numbers.
#pragma once

#include <string_view>
#include <vector>

namespace cli {

// Cuts the first line off the text and returns it without white space at its ends.
std::string_view take_line(std::string_view& text);

// The fields of a line: separated by semicolons where there is one, else by commas, else by white space. One separator a line:
// "1,5 2,5" with decimal commas then fails as a number instead of being read as three.
std::vector<std::string_view> row_fields(std::string_view line);

// What instruments write where a point was not measured: nan, bad, no data, asterisks; upper or lower case.
bool is_missing_mark(std::string_view text);

}  // namespace cli
