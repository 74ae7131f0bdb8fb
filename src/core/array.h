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

inline const std::uint8_t* mask_of(const rc_step& step) { return static_cast<const std::uint8_t*>(step.mask.data); }

}  // namespace rc
