// Many small contacts in one call: each is solved and certified by one block of threads.
#pragma once

#include <roughcontact/plugin.h>

#include <cstdint>

namespace rc_cuda {

constexpr std::int64_t most_points_of_many = 128 * 128;  // larger contacts fill a device by themselves

rc_status solve_many(const rc_host* host, rc_many* many, const rc_options* options);

}  // namespace rc_cuda
