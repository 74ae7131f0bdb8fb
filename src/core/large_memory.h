// Large arrays on large pages: the system then clears and maps them in a fraction of the time.
#pragma once

#include <cstddef>
#include <vector>

#include "platform/memory.h"

namespace rc {

inline constexpr std::size_t large_bytes = std::size_t{1} << 22;

// For memory that nobody has written to yet.
inline void prefer_large(void* begin, std::size_t bytes) {
  if (bytes >= large_bytes) rc_platform::prefer_large_pages(begin, bytes);
}

template <class Value> void reserve_large(std::vector<Value>& values, std::size_t n) {
  values.reserve(n);
  prefer_large(values.data() + values.size(), (values.capacity() - values.size()) * sizeof(Value));
}

template <class Value> std::vector<Value> large_vector(std::size_t n) {
  std::vector<Value> values;
  reserve_large(values, n);
  values.resize(n);
  return values;
}

}  // namespace rc
