// Reads the public structs of callers with older or newer headers, and checks their values.
#pragma once

#include <roughcontact/surface.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "abi/sized_struct.h"

namespace rc::surface {

inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
inline constexpr double pi = 3.14159265358979323846;

inline void check_shape(std::int64_t nx, std::int64_t ny) {
  constexpr std::int64_t most = std::int64_t{1} << 40;
  if (nx < 1 || ny < 1) fail(RC_ERR_SHAPE, "nx = ", nx, ", ny = ", ny, ": at least 1 x 1 points are needed");
  if (nx > most / ny) fail(RC_ERR_SHAPE, "nx = ", nx, ", ny = ", ny, ": more than 2^40 points");
}

inline void check_positive(const char* name, double value) {
  if (!(value > 0) || !std::isfinite(value)) fail(RC_ERR_ARGUMENT, name, " = ", value, " must be positive and finite");
}

// Checks a length, wave number or slope. Beyond these limits areas, wave numbers and their ratios would overflow.
inline void check_magnitude(const char* name, double value) {
  check_positive(name, value);
  if (value < 1e-60 || value > 1e60) fail(RC_ERR_ARGUMENT, name, " = ", value, " is not in 1e-60 .. 1e60; choose another unit");
}

inline void check_at_least_zero(const char* name, double value) {
  if (!(value >= 0) || !std::isfinite(value)) fail(RC_ERR_ARGUMENT, name, " = ", value, " must be finite and at least 0");
}

// The same for a value that is 0 if it is not wanted.
inline void check_magnitude_or_zero(const char* name, double value) {
  check_at_least_zero(name, value);
  if (value > 0) check_magnitude(name, value);
}

inline void check_output(const void* out) {
  if (!out) fail(RC_ERR_ARGUMENT, "out is null");
}

}  // namespace rc::surface
