// FFTW ends the process where its planner gets no memory.
#pragma once

#include <cstdint>
#include <new>

namespace rc_common {

// False where a transform of that length cannot be planned with the memory there is: as much as it takes is had and given back
// before. Planning out-of-place transforms of lines took at most a tenth of that.
inline bool planner_has_memory(std::int64_t length) {
  const std::size_t bytes = (std::size_t{4} << 20) + 256 * static_cast<std::size_t>(length);
  void* const block = ::operator new(bytes, std::nothrow);
  ::operator delete(block);
  return block != nullptr;
}

}  // namespace rc_common
