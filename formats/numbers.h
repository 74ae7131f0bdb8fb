// Numbers from text, with a point as decimal mark in every locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rc::formats {

// The whole text as one number ("nan" and "inf" included), or nothing.
std::optional<double> to_number(std::string_view text);
std::optional<std::int64_t> to_integer(std::string_view text);

// The number that the text begins with, and what follows it; nothing if it begins with none.
std::optional<std::pair<double, std::string_view>> leading_number(std::string_view text);

// A finite number given for `what`, else an Error that says what was given.
double finite_number(std::string_view what, std::string_view text);
double positive_number(std::string_view option, std::string_view text);
// A number of points from 1 on.
std::int64_t whole_number(std::string_view what, std::string_view text);

std::vector<std::string_view> split(std::string_view text, char separator);

}  // namespace rc::formats
