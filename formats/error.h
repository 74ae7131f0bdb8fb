// A failure that the user can act on. Its text is "what, which value, which limit or what to do"; the command prints it as one
// line and exits with code 1.
#pragma once

#include <stdexcept>

#include "core/text.h"

namespace rc::formats {

struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
  // The parts joined, as by rc::join.
  template <class... Parts> explicit Error(const Parts&... parts) : runtime_error(join(parts...)) {}
};

}  // namespace rc::formats
