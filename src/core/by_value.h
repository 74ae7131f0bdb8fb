// std::clamp, std::max and std::min by value. The standard functions take references, and nvcc compiles a reference to a
// constexpr constant of the host into a trap; likewise the check of limits in std::clamp of some standard libraries.
#pragma once

namespace rc {

template <class Value> constexpr Value larger_of(Value a, Value b) { return a < b ? b : a; }
template <class Value> constexpr Value smaller_of(Value a, Value b) { return b < a ? b : a; }
template <class Value> constexpr Value within(Value value, Value least, Value most) {
  return value < least ? least : most < value ? most : value;
}

}  // namespace rc
