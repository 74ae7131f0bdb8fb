// A gap in the memory of a device.
#pragma once

#include <string>

#include "grid/gap_values.h"

namespace rc {

// A gap that a contact has a copy of, where solvers of that device can read it.
struct GapOnDevice {
  const void* at = nullptr;  // null: there is none
  GapValues copy;
  std::string memory;  // the backend's name

  bool is_of(const GapValues& gap) const { return at && copy.is_array_of(gap); }
};

}  // namespace rc
