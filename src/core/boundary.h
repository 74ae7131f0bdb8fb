// Along which axes a half-space grid repeats.
#pragma once

#include <roughcontact/roughcontact.h>

#include <cstdint>

namespace rc {

constexpr bool repeats_along_x(std::int32_t boundary) {
  return boundary == RC_BOUNDARY_PERIODIC || boundary == RC_BOUNDARY_PERIODIC_X;
}
constexpr bool repeats_along_y(std::int32_t boundary) {
  return boundary == RC_BOUNDARY_PERIODIC || boundary == RC_BOUNDARY_PERIODIC_Y;
}

}  // namespace rc
