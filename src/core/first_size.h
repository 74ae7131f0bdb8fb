// Sizes of public structs when they were first released.
#pragma once

#include <roughcontact/registry.h>

#include <cstddef>

namespace rc {

template <class Struct> inline constexpr std::size_t first_size = 0;

}  // namespace rc

// last: the last member of the first release. bytes: the size up to there where pointers have 64 bits; with it no later member
// can take the place of the last one unnoticed.
#define RC_FIRST_SIZE(Struct, last, bytes)                                                                       \
  template <>                                                                                                    \
  inline constexpr std::size_t first_size<Struct> =                                                              \
      (offsetof(Struct, last) + sizeof(Struct::last) + alignof(Struct) - 1) / alignof(Struct) * alignof(Struct); \
  static_assert(sizeof(void*) != 8 || first_size<Struct> == (bytes))

namespace rc {

RC_FIRST_SIZE(rc_option_spec, maximum, 64);

}  // namespace rc
