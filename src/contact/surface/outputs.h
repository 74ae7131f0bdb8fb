// The caller's arrays of one call.
#pragma once

#include <roughcontact/roughcontact.h>

#include <cstddef>

namespace rc {

// One that is to be filled, of 8 or 4 bytes a value, or none.
struct OutputArray {
  double* in_double = nullptr;
  float* in_single = nullptr;

  bool wanted() const { return in_double || in_single; }
  void put(std::size_t i, double value) const {
    if (in_double) in_double[i] = value;
    if (in_single) in_single[i] = static_cast<float>(value);
  }
  // The value that a caller has put there to be certified.
  double at(std::size_t i) const { return in_double ? in_double[i] : static_cast<double>(in_single[i]); }
};

struct Outputs {
  OutputArray p = {};            // [points of this process]
  OutputArray gap = {};          // likewise
  const char* memory = nullptr;  // where they lie: null in the host's memory, else the name of a backend with a device
};

inline Outputs outputs_of(const rc_result& result) {
  return {{result.p, result.p_single}, {result.gap, result.gap_single}, result.memory};
}
// A result with these arrays, for a caller's function.
inline rc_result result_with(const Outputs& outputs) {
  rc_result result{};
  result.struct_size = sizeof(rc_result);
  result.p = outputs.p.in_double;
  result.p_single = outputs.p.in_single;
  result.gap = outputs.gap.in_double;
  result.gap_single = outputs.gap.in_single;
  return result;
}

}  // namespace rc
