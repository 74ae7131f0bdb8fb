// Many small contacts in one call: each is solved and certified by one block of threads.
#pragma once

#include <roughcontact/plugin.h>

namespace rc_cuda {

rc_status solve_many(const rc_host* host, rc_many* many, const rc_options* options) noexcept;

}  // namespace rc_cuda
