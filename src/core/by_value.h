// std::clamp, std::max and std::min by value. Code for devices needs them: a constant of the host to which they take a reference
// is not there, nor is the check of limits that some standard libraries have, and compilers make a trap of either.
#pragma once

namespace rc {

template <class Value> constexpr Value larger_of(Value a, Value b) { return a < b ? b : a; }
template <class Value> constexpr Value smaller_of(Value a, Value b) { return b < a ? b : a; }
template <class Value> constexpr Value within(Value value, Value least, Value most) {
  return value < least ? least : most < value ? most : value;
}

}  // namespace rc
