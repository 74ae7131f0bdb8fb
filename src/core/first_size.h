// Sizes of public structs in release 0.1.0: a caller's struct may be larger or smaller than the library's, but not smaller than
// that.
#pragma once

#include <cstddef>

namespace rc {

// A struct that grows after the release gets a specialisation: the size up to its last member of the release.
template <class Struct> inline constexpr std::size_t first_size = sizeof(Struct);

}  // namespace rc
