// Callers' arrays, in memory that this process reads.
#pragma once

#include <roughcontact/roughcontact.h>

#include <cstddef>
#include <cstdint>

namespace rc {

inline rc_const_array read_only(const rc_array& array) { return {array.data, array.type, array.reserved, array.memory}; }

// native: of RC_NATIVE.
template <class Array> std::size_t bytes_of_value(const Array& array, std::size_t native) {
  return array.type == RC_SINGLE ? sizeof(float) : native;
}

// Element i of an array of doubles or floats.
inline double value_at(const rc_const_array& array, std::size_t i) {
  return array.type == RC_SINGLE ? static_cast<double>(static_cast<const float*>(array.data)[i])
                                 : static_cast<const double*>(array.data)[i];
}

// The values of an array of RC_NATIVE in the host's memory, whose type there is Value; null: no array.
template <class Value> const Value* values_of(const rc_const_array& array) { return static_cast<const Value*>(array.data); }
template <class Value> Value* values_of(const rc_array& array) { return static_cast<Value*>(array.data); }

// The array from value `first` on; none of none. native: bytes of a value of RC_NATIVE.
inline rc_const_array from_value(rc_const_array array, std::int64_t first, std::size_t native) {
  if (array.data)
    array.data = static_cast<const std::byte*>(array.data) + first * static_cast<std::int64_t>(bytes_of_value(array, native));
  return array;
}
inline rc_array from_value(rc_array array, std::int64_t first, std::size_t native) {
  if (array.data)
    array.data = static_cast<std::byte*>(array.data) + first * static_cast<std::int64_t>(bytes_of_value(array, native));
  return array;
}

}  // namespace rc
