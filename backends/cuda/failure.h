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

}  // namespace rc_cuda
