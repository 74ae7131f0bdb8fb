/* In the place of the runtime's questions about devices: the answers of another machine. RC_OTHER_DRIVER="ERROR DEVICES DRIVER
 * CAPABILITY": the status of cudaGetDeviceCount, how many there are, the driver's version, ten times the compute capability. */
#include <cuda_runtime_api.h>
#include <stdio.h>
#include <stdlib.h>

static int answer(int which) {
  int all[4] = {0, 0, 0, 0};
  const char* given = getenv("RC_OTHER_DRIVER");
  if (given) sscanf(given, "%d %d %d %d", &all[0], &all[1], &all[2], &all[3]);
  return all[which];
}

cudaError_t cudaGetDeviceCount(int* count) {
  *count = answer(1);
  return (cudaError_t)answer(0);
}

cudaError_t cudaDriverGetVersion(int* version) {
  *version = answer(2);
  return cudaSuccess;
}

cudaError_t cudaDeviceGetAttribute(int* value, enum cudaDeviceAttr attribute, int device) {
  (void)device;
  *value = attribute == cudaDevAttrComputeCapabilityMajor   ? answer(3) / 10
           : attribute == cudaDevAttrComputeCapabilityMinor ? answer(3) % 10
                                                            : 0;
  return cudaSuccess;
}
