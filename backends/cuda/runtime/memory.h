// Memory on the device that is given back where it goes out of scope.
#pragma once

#include <cstddef>
#include <utility>

#include "runtime/device.h"

namespace rc_cuda {

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

}  // namespace rc_cuda
