// Failures of this plugin, and those that its driver reports.
#pragma once

#include "common/failure.h"

#ifdef __CUDACC__
RC_FAILURES_OF(rc_cuda, "cuda", "use a smaller domain or another backend (\"fft\")")
#else
RC_FAILURES_OF(rc_cuda, "cuda-host", "use a smaller domain or another backend (\"fft\")")
#endif

namespace rc_cuda {

// A call of the runtime that returned an error, in its words.
[[noreturn]] inline void driver_failed(const char* call, const char* words, bool of_memory) {
  fail(of_memory ? RC_ERR_MEMORY : RC_ERR_EXTERNAL, call, ": ", words, "; ",
       of_memory ? "use a smaller domain or another backend (\"fft\")" : "the contact can go on with another backend (\"fft\")");
}

// A caller's address that is elsewhere.
[[noreturn]] inline void not_in_memory(const void* address, std::int64_t device) {
  fail(RC_ERR_ARGUMENT, address, " is not an address in the memory of device ", device, "; option ", component.name,
       ".index names the device");
}

}  // namespace rc_cuda
