// Lines of numbers.
#pragma once

#include <string_view>
#include <vector>

namespace rc::formats {

// Cuts the first line off the text and returns it without white space at its ends.
std::string_view take_line(std::string_view& text);

// The fields of a line: separated by semicolons if it has one, else by commas, else by white space. A line has one kind of
// separator, so that "1,5 2,5" with decimal commas fails as a number instead of being read as three.
std::vector<std::string_view> row_fields(std::string_view line);

// Whether the text marks a point that was not measured: nan, bad, no data, asterisks; in upper or lower case.
bool is_missing_mark(std::string_view text);

}  // namespace rc::formats
