// Whether sets of points in contact, and of points at the hardness, grow with the approach.
#pragma once

#include <roughcontact/roughcontact.h>

#include <cstdint>

namespace rc {

// Whether the inverse of a caller's matrix (RC_OPERATOR_DENSE) on the points that are not masked has, to round-off, no positive
// entry off its diagonal and no negative sum of a row. The same then holds on each set of points, so that no pressure falls as
// the approach grows: docs/development/derivation.md, Laws. Takes some 2 n^3 operations.
bool sets_grow(const rc_system& system, const std::uint8_t* mask);

}  // namespace rc
