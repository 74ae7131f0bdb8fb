// SI prefixes for labels.
#pragma once

#include <string>

namespace cli {

// The prefix under which a value of this magnitude has one to three digits before the point.
struct Prefix {
  double factor;
  std::string symbol;
};
Prefix prefix_for(double magnitude);

}  // namespace cli
