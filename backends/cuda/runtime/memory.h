// Memory on the device.
#pragma once

#include <cstddef>
#include <utility>

#include "runtime/device.h"

namespace rc_cuda {

// It is given back at the end of its scope.
class Memory {
 public:
  Memory() = default;
  Memory(Device& device, std::size_t bytes) : at_(device.allocate(bytes)), bytes_(bytes) {}
  Memory(Memory&& other) noexcept { swap(other); }
  Memory& operator=(Memory&& other) noexcept {
    swap(other);
    return *this;
  }
  ~Memory() {
    if (at_) Device::release(at_);
  }

  std::size_t bytes() const { return bytes_; }
  template <class T> T* as(std::size_t first_byte = 0) const {
    return reinterpret_cast<T*>(static_cast<unsigned char*>(at_) + first_byte);
  }

 private:
  void swap(Memory& other) {
    std::swap(at_, other.at_);
    std::swap(bytes_, other.bytes_);
  }

  void* at_ = nullptr;
  std::size_t bytes_ = 0;
};

// Lays out one array after the other; without memory it counts their bytes.
class Layout {
 public:
  explicit Layout(unsigned char* memory) : memory_(memory) {}
  template <class T> T* next(std::size_t count) {
    T* const at = memory_ ? reinterpret_cast<T*>(memory_ + used_) : nullptr;
    used_ += rounded(count * sizeof(T));
    return at;
  }
  std::size_t used() const { return used_; }

 private:
  unsigned char* memory_;
  std::size_t used_ = 0;
};

}  // namespace rc_cuda
