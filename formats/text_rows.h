// Lines of numbers.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace rc::formats {

// Cuts the first line off the text and returns it without white space at its ends. A line ends with LF, CR LF or CR.
std::string_view take_line(std::string_view& text);

// The same with the white space at its ends: a tab there may stand for an empty field.
std::string_view take_whole_line(std::string_view& text);

// The fields of a line: separated by semicolons if it has one, else by tabs if these divide it into single words, else by commas,
// else by white space. Commas are decimal marks if white space separates the fields and each comma stands within one ("1,5 2,5").
// A separator at the end of the line begins an empty field. Throws an Error if commas may be both.
std::vector<std::string_view> row_fields(std::string_view line);

std::string_view without_quotes(std::string_view field);

// The number in a field: quotes around it, a decimal comma and Fortran's exponents (1.0D-06) are understood.
std::optional<double> field_number(std::string_view field);

// Whether the text marks a point that was not measured: nan, bad, no data, asterisks, dashes and the like, in upper or lower
// case.
bool is_missing_mark(std::string_view text);

// Throws an Error if the file is no text.
void check_text(std::string_view file);

}  // namespace rc::formats
