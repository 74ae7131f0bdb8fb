// The points of a loading sequence: one number, a list "a,b,c" or a range of n points with both ends, equidistant "a:b:n" or with
// equal ratios "a:b:nlog"; every number may have a unit.
#pragma once

#include <string_view>
#include <vector>

#include "units.h"

namespace cli {

// In SI units; numbers alone count in `unit`. `option` is named in errors. Negative and non-finite targets are errors.
std::vector<double> parse_targets(std::string_view option, std::string_view text, Dimension dimension, double unit = 1);

}  // namespace cli
