// A CUDA device: launches, its memory, and cuFFT.
#pragma once

#include <cuda_runtime.h>
#include <cufft.h>

#include <algorithm>
#include <cstddef>
#include <roughcontact/plugin.hpp>
#include <type_traits>
#include <utility>

#include "failure.h"
#include "runtime/index.h"

namespace rc_cuda {

inline void checked(cudaError_t error, const char* call) {
  if (error == cudaSuccess) return;
  cudaGetLastError();  // the program's next look at it finds none of ours
  driver_failed(call, cudaGetErrorString(error), error == cudaErrorMemoryAllocation);
}

template <class F> __global__ void __launch_bounds__(lanes) each_kernel(const __grid_constant__ F f, Index n) {
  const Index i = static_cast<Index>(blockIdx.x) * lanes + threadIdx.x;
  if (i < n) f(i);
}

template <class Part> __device__ void add_halves(Part* lane) {
  __syncthreads();
  for (int half = lanes / 2; half > 0; half /= 2) {
    if (threadIdx.x < half) lane[threadIdx.x].add(lane[threadIdx.x + half]);
    __syncthreads();
  }
}

// A piece to a block. The block that comes last adds the pieces, in their order.
template <class Part, class F>
__global__ void __launch_bounds__(lanes)
    reduce_kernel(const __grid_constant__ F f, Index n, Part* parts, unsigned* arrived, Part* result) {
  alignas(16) __shared__ unsigned char room[lanes * sizeof(Part)];
  __shared__ bool last;
  Part* const lane = reinterpret_cast<Part*>(room);
  const Index begin = static_cast<Index>(blockIdx.x) * piece + threadIdx.x;
  Part mine;
#pragma unroll 4
  for (int k = 0; k < per_lane; ++k)
    if (const Index i = begin + k * lanes; i < n) mine.add(f(i));
  lane[threadIdx.x] = mine;
  add_halves(lane);
  if (threadIdx.x == 0) {
    parts[blockIdx.x] = lane[0];
    __threadfence();
    last = atomicInc(arrived, gridDim.x - 1) == gridDim.x - 1;  // an integer, which returns to 0 by itself
  }
  __syncthreads();
  if (!last) return;
  __threadfence();
  mine = Part{};
  for (unsigned k = threadIdx.x; k < gridDim.x; k += lanes) mine.add(parts[k]);
  lane[threadIdx.x] = mine;
  add_halves(lane);
  if (threadIdx.x == 0) *result = lane[0];
}

constexpr unsigned together_lanes = 512;

template <class Work> __global__ void __launch_bounds__(together_lanes) together_kernel(const __grid_constant__ Work work) {
  const int phases = work.phases();
  for (int phase = 0; phase < phases; ++phase) {
    const Index count = work.count(phase);
    for (Index i = threadIdx.x; i < count; i += together_lanes) work(phase, i);
    __syncthreads();
  }
}

constexpr std::size_t most_part = 64;  // bytes of what sums are made of

// The threads of one block, which do everything together. Code that calls it is constexpr, and so of both sides for nvcc; on the
// host nothing runs.
class Block {
 public:
  template <class F> RC_CALLED RC_ANYWHERE void each(Index n, const F& f) {
#ifdef __CUDA_ARCH__
    const F own = f;  // a copy in registers: the compiler need not read its members again after a store
    for (Index i = threadIdx.x; i < n; i += lanes) own(i);
    __syncthreads();
#else
    unused(n, f);
#endif
  }
  template <class Part, class F> RC_CALLED RC_ANYWHERE Part reduce(Index n, const F& f) {
    static_assert(sizeof(Part) <= most_part);
    Part sum;
#ifdef __CUDA_ARCH__
    Part* const lane = reinterpret_cast<Part*>(room());
    const F own = f;
    for (Index i = threadIdx.x; i < n; i += lanes) sum.add(own(i));
    lane[threadIdx.x] = sum;
    add_halves(lane);
    sum = lane[0];
    __syncthreads();
#else
    unused(n, f);
#endif
    return sum;
  }
  template <class Work> RC_ANYWHERE void together(const Work& work) {
    const int phases = work.phases();
    for (int phase = 0; phase < phases; ++phase) each(work.count(phase), [work, phase](Index i) { work(phase, i); });
  }
  // The number that the counter shows, which it then raises: blocks share work by it.
  RC_ANYWHERE unsigned take(unsigned* counter) {
#ifdef __CUDA_ARCH__
    unsigned* const taken = reinterpret_cast<unsigned*>(room());
    if (threadIdx.x == 0) *taken = atomicAdd(counter, 1U);
    __syncthreads();
    const unsigned result = *taken;
    __syncthreads();
    return result;
#else
    return *counter;
#endif
  }

  // Its values are not to take registers from those who compute.
  template <class T> RC_ANYWHERE void keep_in_memory(T& object) {
#ifdef __CUDA_ARCH__
    asm volatile("" : : "l"(&object) : "memory");
#else
    unused(object);
#endif
  }

 private:
  template <class... Values> RC_ANYWHERE static void unused(const Values&...) {}
#ifdef __CUDA_ARCH__
  __device__ static unsigned char* room() {
    alignas(16) __shared__ unsigned char bytes[lanes * most_part];
    return bytes;
  }
#endif
};

constexpr int blocks_beside = 2;  // on each of the device's processors

template <class Work> __global__ void __launch_bounds__(lanes, blocks_beside) blocks_kernel(const __grid_constant__ Work work) {
  extern __shared__ __align__(16) unsigned char fastest[];
  Block block;
  work(block, static_cast<Index>(blockIdx.x), fastest);
}

// Bytes that nobody has taken of the device of that number.
std::size_t free_bytes_of(Index index);

class Device;

// Until its end the calling thread's device is that of this number; then the one before is again.
class Current {
 public:
  explicit Current(Index index) : own_(static_cast<int>(index)) {
    checked(cudaGetDevice(&before_), "cudaGetDevice");
    checked(cudaSetDevice(own_), "cudaSetDevice");
  }
  explicit Current(const Device& device);
  // cudaSetDevice makes a context on the device, so it is not called if the device has not changed.
  ~Current() {
    if (before_ != own_) cudaSetDevice(before_);
  }
  Current(const Current&) = delete;
  Current& operator=(const Current&) = delete;

 private:
  const int own_;
  int before_ = 0;
};

class Device {
 public:
  Device(const rc_host* host, Index index);
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  ~Device();

  const rc_host* host() const { return host_; }
  // The host of the contact that uses the device now, and the threads that copy for it; team null: one thread copies.
  void serve(const rc_host* host, const rc_team* team) {
    host_ = host;
    team_ = team;
  }
  Index index() const { return index_; }
  cudaStream_t stream() const { return stream_; }
  std::size_t free_bytes() { return free_bytes_of(index_); }
  void* allocate(std::size_t bytes);
  static void release(void* memory) noexcept {
    cudaFree(memory);
    cudaGetLastError();  // clears the error of a lost device, so that the program's next call does not report it
  }
  void upload(void* to, const void* from, std::size_t bytes);
  void download(void* to, const void* from, std::size_t bytes);
  void clear(void* memory, std::size_t bytes) { checked(cudaMemsetAsync(memory, 0, bytes, stream_), "cudaMemsetAsync"); }
  void wait() { checked(cudaStreamSynchronize(stream_), "cudaStreamSynchronize"); }
  // Waits for all work on the device, whoever gave it.
  void wait_for_all() { checked(cudaDeviceSynchronize(), "cudaDeviceSynchronize"); }
  // Where kernels find what a caller has there. Fails where that is not in this device's memory.
  const void* found(const void* callers) const;

  template <class F> void each(Index n, const F& f) { launch(each_kernel<F>, (n + lanes - 1) / lanes, lanes, f, n); }
  template <class Part, class F> Part reduce(Index n, const F& f) {
    static_assert(sizeof(Part) <= most_part);
    const Index pieces = (n + piece - 1) / piece;
    make_parts(static_cast<std::size_t>(pieces) * sizeof(Part));
    launch(reduce_kernel<Part, F>, pieces, lanes, f, n, static_cast<Part*>(parts_), arrived_, static_cast<Part*>(seen_));
    wait();
    return *static_cast<const Part*>(seen_);
  }
  template <class Work> void together(const Work& work) { launch(together_kernel<Work>, 1, together_lanes, work); }
  // How many blocks run at a time, each with so many bytes of the fastest memory; and how many bytes a block may have.
  template <class Work> Index blocks_at_a_time(std::size_t shared) {
    int beside = 0;
    // The limit belongs to the kernel, which all host threads share: it is set to the most that a grid may need.
    checked(
        cudaFuncSetAttribute(blocks_kernel<Work>, cudaFuncAttributeMaxDynamicSharedMemorySize, static_cast<int>(most_shared())),
        "cudaFuncSetAttribute");
    checked(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&beside, blocks_kernel<Work>, lanes, shared),
            "cudaOccupancyMaxActiveBlocksPerMultiprocessor");
    return std::max(1, beside) * attribute(cudaDevAttrMultiProcessorCount);
  }
  std::size_t most_shared() {
    return static_cast<std::size_t>(attribute(cudaDevAttrMaxSharedMemoryPerBlockOptin)) - lanes * most_part - 1024;
  }
  // Bytes that the device takes for the stacks of all threads that can run at a time, at the first launch of this work.
  template <class Work> std::size_t bytes_of_stacks() const {
    cudaFuncAttributes kernel{};
    checked(cudaFuncGetAttributes(&kernel, blocks_kernel<Work>), "cudaFuncGetAttributes");
    return kernel.localSizeBytes * static_cast<std::size_t>(attribute(cudaDevAttrMaxThreadsPerMultiProcessor)) *
           static_cast<std::size_t>(attribute(cudaDevAttrMultiProcessorCount));
  }
  // work(block, its number, its fastest memory), after blocks_at_a_time() of the same work.
  template <class Work> void blocks(Index count, std::size_t shared, const Work& work) {
    launch_with(shared, blocks_kernel<Work>, count, lanes, work);
  }

 private:
  void make_parts(std::size_t bytes);
  void copy(void* to, const void* from, std::size_t bytes, cudaMemcpyKind kind);
  bool staged(std::size_t bytes);  // whether a copy of that size uses the stages; allocates them if it does
  void give_back() noexcept;
  Index attribute(cudaDeviceAttr wanted) const {
    int value = 0;
    checked(cudaDeviceGetAttribute(&value, wanted, static_cast<int>(index_)), "cudaDeviceGetAttribute");
    return value;
  }
  template <class... Wanted, class... Given>
  void launch(void (*kernel)(Wanted...), Index blocks, unsigned threads, const Given&... given) {
    launch_with(0, kernel, blocks, threads, given...);
  }
  template <class... Wanted, class... Given>
  void launch_with(std::size_t shared, void (*kernel)(Wanted...), Index blocks, unsigned threads, const Given&... given) {
    cudaLaunchConfig_t config{};
    config.dynamicSmemBytes = shared;
    config.gridDim = dim3(static_cast<unsigned>(blocks));
    config.blockDim = dim3(threads);
    config.stream = stream_;
    checked(cudaLaunchKernelEx(&config, kernel, static_cast<const std::decay_t<Wanted>&>(given)...), "cudaLaunchKernelEx");
  }

  const rc_host* host_;
  Index index_;
  cudaStream_t stream_ = nullptr;
  unsigned* arrived_ = nullptr;
  void* parts_ = nullptr;
  void* seen_ = nullptr;  // on the host, where kernels write sums
  std::size_t parts_bytes_ = 0;

  // Pinned memory of the host: the driver copies one stage while the team fills or empties the other.
  struct Stage {
    unsigned char* bytes = nullptr;
    cudaEvent_t free = nullptr;
  };
  const rc_team* team_ = nullptr;
  Stage stages_[2];
};

inline Current::Current(const Device& device) : Current(device.index()) {}

// As in host_device.h.
template <class Real> class Lines {
 public:
  struct Shape {
    Index length, count;
    Index pitch;
    bool inverse;
  };

  Lines(Device& device, const Shape& shape);
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;
  ~Lines() { cufftDestroy(plan_); }
  std::size_t work_bytes() const { return work_bytes_; }
  void run(Device& device, Real* data, void* work) const;

 private:
  Shape shape_;
  cufftHandle plan_ = 0;
  std::size_t work_bytes_ = 0;
};

}  // namespace rc_cuda
