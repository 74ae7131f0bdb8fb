// Large arrays on large pages: the system then clears and maps them in a fraction of the time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <roughcontact/plugin.hpp>
#include <vector>

#include "core/error.h"
#include "platform/memory.h"

namespace rc {

inline constexpr std::size_t large_bytes = std::size_t{1} << 22;

// For memory that nobody has written to yet.
inline void prefer_large(void* begin, std::size_t bytes) {
  if (bytes >= large_bytes) rc_platform::prefer_large_pages(begin, bytes);
}

template <class Value> void reserve_large(std::vector<Value>& values, std::size_t n) {
  try {
    values.reserve(n);
  } catch (const std::bad_alloc&) {
    throw OutOfMemory(n * sizeof(Value));
  }
  prefer_large(values.data() + values.size(), (values.capacity() - values.size()) * sizeof(Value));
}

template <class Value> std::vector<Value> large_vector(std::size_t n) {
  std::vector<Value> values;
  reserve_large(values, n);
  values.resize(n);
  return values;
}

// The same; all threads touch the new pages, since the system takes long to provide each.
template <class Value> std::vector<Value> large_vector(std::size_t n, const rc_team& team) {
  constexpr std::size_t page = 4096, at_once = large_bytes;
  std::vector<Value> values;
  reserve_large(values, n);
  volatile char* const memory = reinterpret_cast<char*>(values.data());
  const std::size_t bytes = n * sizeof(Value);
  roughcontact::for_each(team, static_cast<std::int64_t>(bytes / at_once), true, [&](std::int64_t item, std::int64_t) {
    const std::size_t begin = static_cast<std::size_t>(item) * at_once;
    for (std::size_t at = begin; at < begin + at_once; at += page) memory[at] = 0;
  });
  values.resize(n);
  return values;
}

}  // namespace rc
