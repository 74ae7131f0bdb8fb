// SI prefixes and lengths named by text.
#pragma once

#include <optional>
#include <string_view>

namespace rc::formats {

// The factor of an SI prefix; 1 for "". Micro is u, U+00B5, U+03BC or Latin-1. Nothing if the text is no prefix.
std::optional<double> prefix_factor(std::string_view prefix);

// Metres per unit: "m" with any SI prefix. Nothing if the text is no such length.
std::optional<double> metres_per(std::string_view unit);

}  // namespace rc::formats
