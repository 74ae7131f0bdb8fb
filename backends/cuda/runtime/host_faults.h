// Lets calls of the host build's runtime fail, as those of a driver may, and counts what travels. Tests alone set it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rc_cuda {

enum class Fault {
  none,
  once,  // this call fails, later ones do not: a kernel that fails
  lost   // this call and all later ones fail: a device that is lost
};

struct HostFaults {
  Fault fault = Fault::none;
  std::int64_t at = 0;        // the number of the call that fails
  std::int64_t calls = 0;     // made so far
  const char* device = "";    // why there is no device; "": there is one
  std::size_t memory = 0;     // of the device; 0: the host's
  std::size_t allocated = 0;  // of it
  bool counts = false;        // the bytes that travel
  std::int64_t to_device = 0, to_host = 0;
};

HostFaults& host_faults();

// Addresses of the device begin here: far above the host's memory, so that no caller takes one for the other.
constexpr std::uintptr_t device_addresses = std::uintptr_t{1} << 62;

}  // namespace rc_cuda
