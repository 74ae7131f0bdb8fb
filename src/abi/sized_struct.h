// Structs that grow: converts between an older or newer caller's struct and today's.
#pragma once

#include <roughcontact/analysis.h>
#include <roughcontact/derivatives.h>
#include <roughcontact/direct.h>
#include <roughcontact/history.h>
#include <roughcontact/registry.h>

#include <algorithm>
#include <cstring>

#include "core/error.h"

namespace rc {

// Sizes when the structs were first released. Literals: they must not follow today's sizeof.
template <class Struct> inline constexpr std::size_t first_size = 0;
template <> inline constexpr std::size_t first_size<rc_system> = 88;
template <> inline constexpr std::size_t first_size<rc_step> = 48;
template <> inline constexpr std::size_t first_size<rc_result> = 432;
template <> inline constexpr std::size_t first_size<rc_accuracy> = 48;
template <> inline constexpr std::size_t first_size<rc_level> = 88;
template <> inline constexpr std::size_t first_size<rc_state> = 72;
template <> inline constexpr std::size_t first_size<rc_path> = 120;
template <> inline constexpr std::size_t first_size<rc_batch> = 200;
template <> inline constexpr std::size_t first_size<rc_gradient> = 88;
template <> inline constexpr std::size_t first_size<rc_tangent> = 88;
template <> inline constexpr std::size_t first_size<rc_direct> = 248;
template <> inline constexpr std::size_t first_size<rc_area> = 40;
template <> inline constexpr std::size_t first_size<rc_patches> = 96;
template <> inline constexpr std::size_t first_size<rc_histogram> = 80;
template <> inline constexpr std::size_t first_size<rc_context_config> = 40;
template <> inline constexpr std::size_t first_size<rc_component> = 40;
template <> inline constexpr std::size_t first_size<rc_option_spec> = 64;

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

// Writes as much as the caller knows; its struct_size stays.
template <class Struct> void write(Struct* to, const Struct& value) {
  const std::size_t size = to->struct_size;
  std::memcpy(to, &value, std::min(size, sizeof(Struct)));
  to->struct_size = size;
}

}  // namespace rc
