// The names by which the components and options of a build are known.
#pragma once

#ifdef __CUDACC__
#define RC_CUDA_NAME "cuda"
#else
#define RC_CUDA_NAME "cuda-host"
#endif

namespace rc_cuda::names {

constexpr char backend[] = RC_CUDA_NAME, solver[] = "haar-" RC_CUDA_NAME;
constexpr char index[] = RC_CUDA_NAME ".index", memory_limit[] = RC_CUDA_NAME ".memory_limit";

}  // namespace rc_cuda::names
