// FFTW ends the process where its planner gets no memory.
#pragma once

#include <cstdint>
#include <new>

namespace rc_common {

// False if there is too little memory to plan a transform of that length. It tries to allocate ten times what the planning of
// out-of-place transforms of lines takes, and frees it.
inline bool planner_has_memory(std::int64_t length) {
  const std::size_t bytes = (std::size_t{4} << 20) + 256 * static_cast<std::size_t>(length);
  void* const block = ::operator new(bytes, std::nothrow);
  ::operator delete(block);
  return block != nullptr;
}

}  // namespace rc_common
