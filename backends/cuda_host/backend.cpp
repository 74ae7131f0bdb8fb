// The code of the plugin `cuda`, compiled for the host: loops in the place of launches, FFTW in that of cuFFT. Tests run it where
// there is no device.
#include "cuda/tables.h"

RC_PLUGIN_ENTRY(cuda_host, , out) {
  static const rc_plugin plugin = rc_cuda::plugin_named("cuda_host");
  *out = &plugin;
  return RC_OK;
}
