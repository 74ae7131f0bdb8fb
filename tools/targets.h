// The points of a loading sequence: one number, a list "a,b,c" or a range "a:b:n" of n equidistant points, both ends included.
#pragma once

#include <string_view>
#include <vector>

namespace cli {

// `option` is named in errors. Negative and non-finite targets are errors.
std::vector<double> parse_targets(std::string_view option, std::string_view text);

}  // namespace cli
