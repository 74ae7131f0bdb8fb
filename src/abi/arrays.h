// Callers' arrays, checked before they are used: what a call does not take is refused by the array's name.
#pragma once

#include <initializer_list>

#include "core/array.h"
#include "core/error.h"

namespace rc {

// The types of an array of the caller's: RC_NATIVE, or also RC_SINGLE.
enum class Types { native, floats };

template <class Array> void check_array(const Array& array, const char* name, Types types) {
  const bool floats = types == Types::floats;
  if (array.type != RC_NATIVE && !(floats && array.type == RC_SINGLE))
    fail(RC_ERR_ARGUMENT, name, ".type = ", array.type, floats ? " is neither RC_NATIVE nor RC_SINGLE" : " is not RC_NATIVE");
  if (array.reserved != 0) fail(RC_ERR_ARGUMENT, name, ".reserved = ", array.reserved, " must be 0");
}

// Whether check_host_array takes it as RC_NATIVE.
template <class Array> bool is_plain(const Array& array) {
  return array.type == RC_NATIVE && array.reserved == 0 && !array.memory;
}

template <class Array> void check_host_array(const Array& array, const char* name, Types types = Types::native) {
  check_array(array, name, types);
  if (array.memory)
    fail(RC_ERR_ARGUMENT, name, ".memory = \"", array.memory,
         "\": this call takes arrays in the host's memory only; copy it there, and set memory to null");
}

template <class Array> struct Named {
  const char* name;
  const Array& array;
};
template <class Array> void check_host_arrays(std::initializer_list<Named<Array>> arrays) {
  for (const auto& [name, array] : arrays) check_host_array(array, name);
}

// The values of a checked array; null if there is none.
template <class Value> const Value* host_values(const rc_const_array& array, const char* name) {
  check_host_array(array, name);
  return values_of<Value>(array);
}
template <class Value> Value* host_values(const rc_array& array, const char* name) {
  check_host_array(array, name);
  return values_of<Value>(array);
}

}  // namespace rc
