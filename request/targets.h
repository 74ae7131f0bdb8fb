// Lists and ranges of quantities: "a,b,c", a range of n values with both ends "a..b:n", with equal ratios "a..b:nlog", and an
// interval "a..b"; also "a:b:n". Every number may have a unit.
#pragma once

#include <string_view>
#include <vector>

#include "request/quantities.h"

namespace rc::request {

constexpr int most_targets = 100000;

// Numbers alone count in `unit`. `option` is named in errors. Negative and non-finite targets are errors.
std::vector<Quantity> read_targets(std::string_view option, std::string_view text, Dimension dimension, double unit = 1);

}  // namespace rc::request
