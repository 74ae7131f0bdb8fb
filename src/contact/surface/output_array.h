// An array of the caller's that is to be filled, of 8 or 4 bytes a value, or none.
#pragma once

#include <roughcontact/roughcontact.h>

#include <cstddef>

namespace rc {

struct OutputArray {
  double* in_double = nullptr;
  float* in_single = nullptr;

  bool wanted() const { return in_double || in_single; }
  void put(std::size_t i, double value) const {
    if (in_double) in_double[i] = value;
    if (in_single) in_single[i] = static_cast<float>(value);
  }
};

// The pressure that a caller has put there to be certified.
inline double given_pressure(const rc_result& result, std::size_t i) {
  return result.p ? result.p[i] : static_cast<double>(result.p_single[i]);
}

inline OutputArray pressures_of(const rc_result& result) { return {result.p, result.p_single}; }
inline OutputArray gap_of(const rc_result& result) { return {result.gap, result.gap_single}; }

}  // namespace rc
