// Callers' arrays on the device.
#pragma once

#include <roughcontact/plugin.h>

#include <cstdint>

namespace rc_cuda {

rc_status fetch(const rc_host* host, const rc_options* options, void* to_host, const void* from_device,
                std::int64_t bytes) noexcept;
rc_status store(const rc_host* host, const rc_options* options, void* to_device, const void* from_host,
                std::int64_t bytes) noexcept;

}  // namespace rc_cuda
