// Lengths named by text, and SI prefixes for labels.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace cli {

// Metres per unit: "m" with any SI prefix, the micro sign as u, U+00B5, U+03BC or Latin-1. Nothing if the text is no such length.
std::optional<double> metres_per(std::string_view unit);

// The prefix under which a value of this magnitude has one to three digits before the point.
struct Prefix {
  double factor;
  std::string symbol;
};
Prefix prefix_for(double magnitude);

}  // namespace cli
