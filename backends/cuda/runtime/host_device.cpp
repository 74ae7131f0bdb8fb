#include "runtime/host_device.h"

#include <cstdint>
#include <limits>
#include <new>

#include "platform/memory.h"
#include "runtime/host_faults.h"

namespace rc_cuda {

namespace {

constexpr std::size_t header = 64;  // before each block, which holds its size

}  // namespace

HostFaults& host_faults() {
  static HostFaults faults;
  return faults;
}

Device::Device(const rc_host* host, Index index) : host_(host), index_(index) {
  if (const char* const reason = host_faults().device; *reason != '\0') driver_failed("looking for devices", reason, false);
  if (index != 0) fail(RC_ERR_OPTION, "device ", index, " is not there: the host is device 0 alone");
}

void Device::call(const char* what) {
  HostFaults& faults = host_faults();
  if (faults.fault == Fault::none) return;
  const std::int64_t now = ++faults.calls;
  if (faults.fault == Fault::once ? now == faults.at : now >= faults.at)
    driver_failed(what, faults.fault == Fault::once ? "the kernel failed" : "the device is lost", false);
}

void Device::count(std::size_t to_device, std::size_t to_host) {
  HostFaults& faults = host_faults();
  if (!faults.counts) return;
  faults.to_device += static_cast<std::int64_t>(to_device);
  faults.to_host += static_cast<std::int64_t>(to_host);
}

std::size_t Device::free_bytes() {
  call("free_bytes");
  const HostFaults& faults = host_faults();
  if (faults.memory > 0) return faults.memory - std::min(faults.allocated, faults.memory);
  return static_cast<std::size_t>(std::min(rc_platform::machine_bytes(), 1e18));
}

void* Device::allocate(std::size_t bytes) {
  call("allocate");
  HostFaults& faults = host_faults();
  const bool fits = faults.memory == 0 || faults.allocated + bytes <= faults.memory;
  void* const block = fits ? ::operator new (bytes + header, std::align_val_t{header}, std::nothrow) : nullptr;
  if (!block) driver_failed("allocate", "out of memory", true);
  if (faults.memory > 0) faults.allocated += bytes;
  std::memcpy(block, &bytes, sizeof bytes);
  return static_cast<unsigned char*>(block) + header;
}

void Device::release(void* memory) noexcept {
  void* const block = static_cast<unsigned char*>(memory) - header;
  std::size_t bytes = 0;
  std::memcpy(&bytes, block, sizeof bytes);
  HostFaults& faults = host_faults();
  if (faults.memory > 0) faults.allocated -= std::min(faults.allocated, bytes);
  ::operator delete (block, std::align_val_t{header});
}

const void* Device::found(const void* callers) const {
  const auto address = reinterpret_cast<std::uintptr_t>(callers);
  if ((address & device_addresses) == 0) not_in_memory(callers, index_);
  return reinterpret_cast<const void*>(address - device_addresses);
}

template <class Real> Lines<Real>::Lines(Device& device, const Shape& shape) : shape_(shape) {
  device.call("plan");
  if (shape.length > std::numeric_limits<int>::max()) fail(RC_ERR_SHAPE, "a line of ", shape.length, " values is too long");
  const std::size_t half = static_cast<std::size_t>(shape.length / 2 + 1), whole = static_cast<std::size_t>(shape.length);
  std::vector<Real> in(2 * std::max(half, whole)), out(in.size());
  const rc_common::Planner<Real> planner(device.host(), component, shape.length, shape.count);
  constexpr unsigned flags = FFTW_ESTIMATE | FFTW_UNALIGNED;
  if (shape.pitch > 0)
    plan_ = planner.complex_to_complex(shape.length, in.data(), out.data(), shape.inverse ? FFTW_BACKWARD : FFTW_FORWARD, flags);
  else if (shape.inverse)
    plan_ = planner.complex_to_real(shape.length, in.data(), out.data(), flags | FFTW_PRESERVE_INPUT);
  else
    plan_ = planner.real_to_complex(shape.length, in.data(), out.data(), flags);
  plan_.get_deleter().host = nullptr;  // contacts lend plans to each other
}

template <class Real> void Lines<Real>::run(Device& device, Real* data, void*) const {
  using Fftw = rc_common::Fftw<Real>;
  device.call("transform");
  const Index row = 2 * (shape_.length / 2 + 1);
  std::vector<Real> in(static_cast<std::size_t>(shape_.pitch > 0 ? 2 * shape_.length : row)), out(in.size());
  for (Index line = 0; line < shape_.count; ++line) {
    if (shape_.pitch == 0) {
      std::copy_n(data + line * row, row, in.data());
      if (shape_.inverse)
        Fftw::run_complex_to_real(plan_.get(), in.data(), out.data());
      else
        Fftw::run_real_to_complex(plan_.get(), in.data(), out.data());
      std::copy_n(out.data(), row, data + line * row);
      continue;
    }
    const auto at = [&](Index i) { return data + 2 * (i * shape_.pitch + line); };
    for (Index i = 0; i < shape_.length; ++i) std::copy_n(at(i), 2, in.data() + 2 * i);
    Fftw::run_complex(plan_.get(), in.data(), out.data());
    for (Index i = 0; i < shape_.length; ++i) std::copy_n(out.data() + 2 * i, 2, at(i));
  }
}

template class Lines<float>;
template class Lines<double>;

}  // namespace rc_cuda
