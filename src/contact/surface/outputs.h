// The caller's arrays of one call.
#pragma once

#include <cstddef>

#include "core/array.h"

namespace rc {

// One that is to be filled, of 8 or 4 bytes a value, or none.
struct OutputArray {
  OutputArray() = default;
  OutputArray(double* values) { array.data = values; }
  explicit OutputArray(const rc_array& of) : array(of) {}

  bool wanted() const { return array.data != nullptr; }
  bool single() const { return array.type == RC_SINGLE; }
  void put(std::size_t i, double value) const {
    if (single())
      static_cast<float*>(array.data)[i] = static_cast<float>(value);
    else
      static_cast<double*>(array.data)[i] = value;
  }
  // The value that a caller has put there to be certified.
  double at(std::size_t i) const { return value_at(read_only(array), i); }

  rc_array array = {};
};

struct Outputs {
  OutputArray p = {};    // [points of this process]
  OutputArray gap = {};  // likewise
};

inline Outputs outputs_of(const rc_result& result) { return {OutputArray(result.p), OutputArray(result.gap)}; }
// A result with these arrays, for a caller's function.
inline rc_result result_with(const Outputs& outputs) {
  rc_result result{};
  result.struct_size = sizeof(rc_result);
  result.p = outputs.p.array;
  result.gap = outputs.gap.array;
  return result;
}

}  // namespace rc
