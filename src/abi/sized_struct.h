// Structs that grow: converts between an older or newer caller's struct and the library's.
#pragma once

#include <roughcontact/analysis.h>
#include <roughcontact/derivatives.h>
#include <roughcontact/direct.h>
#include <roughcontact/history.h>
#include <roughcontact/ranks.h>
#include <roughcontact/registry.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "core/error.h"
#include "core/first_size.h"

namespace rc {

template <class Struct> void check_size(const Struct* from, const char* name) {
  if (!from) fail(RC_ERR_ARGUMENT, name, " is null");
  const std::size_t size = from->struct_size;
  if (size < first_size<Struct>)
    fail(RC_ERR_ARGUMENT, name, ".struct_size = ", size, " is smaller than ", first_size<Struct>, "; set it to sizeof(", name,
         ")");
  const auto* bytes = reinterpret_cast<const unsigned char*>(from);
  // A size beyond any plausible growth is an uninitialised field; so much must not be read.
  if (size > sizeof(Struct) + 4096)
    fail(RC_ERR_ARGUMENT, name, ".struct_size = ", size, " is larger than ", sizeof(Struct) + 4096, "; set it to sizeof(", name,
         ")");
  for (std::size_t i = sizeof(Struct); i < size; ++i)
    if (bytes[i] != 0)
      fail(RC_ERR_ARGUMENT, name, ".struct_size = ", size, ": bytes beyond the ", sizeof(Struct),
           " known to this library are set; a newer library is needed");
}

// Reads a caller's struct. Members that an older caller does not know keep the values of `defaults`.
template <class Struct> Struct read(const Struct* from, const char* name, const Struct& defaults) {
  check_size(from, name);
  Struct copy = defaults;
  std::memcpy(&copy, from, std::min(from->struct_size, sizeof(Struct)));
  copy.struct_size = sizeof(Struct);
  return copy;
}

inline void check_switch(std::int32_t value, const char* name) {
  if (value != 0 && value != 1) fail(RC_ERR_ARGUMENT, name, " = ", value, " is neither 0 nor 1");
}
inline void check_reserved(std::int64_t value, const char* name) {
  if (value != 0) fail(RC_ERR_ARGUMENT, name, " = ", value, " must be 0");
}

// Writes the members that fit into the caller's struct; its struct_size does not change.
template <class Struct> void write(Struct* to, const Struct& value) {
  const std::size_t size = to->struct_size;
  std::memcpy(to, &value, std::min(size, sizeof(Struct)));
  to->struct_size = size;
}

}  // namespace rc
