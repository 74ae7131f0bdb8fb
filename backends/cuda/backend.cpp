// The plugin's entry: it hands out the tables of backend and solver, or, without a device, refuses in the driver's words.
#include <cuda_runtime_api.h>

#include <cstdio>

#include "tables.h"

namespace {

constexpr int least_capability = 80;  // the oldest architecture that this is compiled for

// "" where there is a device that can run it.
const char* obstacle(char (&text)[512]) {
  int devices = 0, driver = 0, runtime = 0;
  const cudaError_t error = cudaGetDeviceCount(&devices);
  cudaDriverGetVersion(&driver);
  cudaRuntimeGetVersion(&runtime);
  cudaGetLastError();
  if (error != cudaSuccess || devices == 0) {
    std::snprintf(text, sizeof text,
                  "cuda: no device: %s; driver for CUDA %d.%d, built with CUDA %d.%d; use another backend (\"fft\")",
                  error != cudaSuccess ? cudaGetErrorString(error) : "the driver has none", driver / 1000, driver % 1000 / 10,
                  runtime / 1000, runtime % 1000 / 10);
    return text;
  }
  for (int i = 0; i < devices; ++i) {
    int major = 0, minor = 0;
    if (cudaDeviceGetAttribute(&major, cudaDevAttrComputeCapabilityMajor, i) != cudaSuccess ||
        cudaDeviceGetAttribute(&minor, cudaDevAttrComputeCapabilityMinor, i) != cudaSuccess)
      continue;
    if (10 * major + minor >= least_capability) return "";
  }
  std::snprintf(text, sizeof text,
                "cuda: none of %d device(s) has compute capability %d.%d or above; use another backend (\"fft\")", devices,
                least_capability / 10, least_capability % 10);
  return text;
}

}  // namespace

RC_PLUGIN_ENTRY(cuda, host, out) {
  char text[512];
  if (const char* const reason = obstacle(text); *reason != '\0') return host->fail(host, RC_ERR_PLUGIN, reason);
  static const rc_plugin plugin = rc_cuda::plugin_named("cuda");
  *out = &plugin;
  return RC_OK;
}
