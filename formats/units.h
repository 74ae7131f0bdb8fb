// Lengths named by text.
#pragma once

#include <optional>
#include <string_view>

namespace rc::formats {

// Metres per unit: "m" with any SI prefix, the micro sign as u, U+00B5, U+03BC or Latin-1. Nothing if the text is no such length.
std::optional<double> metres_per(std::string_view unit);

}  // namespace rc::formats
