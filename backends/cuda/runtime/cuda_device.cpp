#include "runtime/cuda_device.h"

#include <cstring>
#include <string>

#include "platform/threads.h"

namespace rc_cuda {

namespace {

const char* text_of(cufftResult result) {
  switch (result) {
    case CUFFT_ALLOC_FAILED:
      return "cuFFT has no memory";
    case CUFFT_INVALID_DEVICE:
      return "cuFFT finds the device invalid";
    case CUFFT_EXEC_FAILED:
      return "cuFFT could not run on the device";
    case CUFFT_SETUP_FAILED:
      return "cuFFT could not be set up";
    case CUFFT_INVALID_SIZE:
      return "cuFFT does not take this size";
    case CUFFT_INTERNAL_ERROR:
      return "an internal error of cuFFT";
    default:
      return "an error of cuFFT";
  }
}

void checked(cufftResult result, const char* call) {
  if (result != CUFFT_SUCCESS)
    driver_failed(call, (std::string(text_of(result)) + " (" + std::to_string(result) + ")").c_str(),
                  result == CUFFT_ALLOC_FAILED);
}

constexpr std::size_t least_staged = std::size_t{1} << 20, stage_bytes = std::size_t{1} << 23, of_item = std::size_t{1} << 19;

void copy_by(const rc_team& team, unsigned char* to, const unsigned char* from, std::size_t bytes) {
  roughcontact::for_each(team, static_cast<std::int64_t>((bytes + of_item - 1) / of_item), true,
                         [&](std::int64_t item, std::int64_t) {
                           const std::size_t begin = static_cast<std::size_t>(item) * of_item;
                           std::memcpy(to + begin, from + begin, std::min(of_item, bytes - begin));
                         });
}

}  // namespace

Device::Device(const rc_host* host, Index index) : host_(host), index_(index) {
  const rc_platform::SignalsBlocked threads_of_the_driver_take_none;
  int devices = 0;
  checked(cudaGetDeviceCount(&devices), "cudaGetDeviceCount");
  if (index >= devices)
    fail(RC_ERR_OPTION, component.name, ".index = ", index, ": the driver has ", devices, " device(s), numbered from 0");
  const Current device(index);
  try {
    checked(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking), "cudaStreamCreateWithFlags");
    void* arrived = nullptr;
    checked(cudaMalloc(&arrived, sizeof *arrived_), "cudaMalloc");
    arrived_ = static_cast<unsigned*>(arrived);
    clear(arrived_, sizeof *arrived_);
    checked(cudaHostAlloc(&seen_, most_part, cudaHostAllocMapped), "cudaHostAlloc");
  } catch (...) {
    give_back();
    throw;
  }
}

Device::~Device() {
  try {
    const Current device(index_);
    give_back();
  } catch (const roughcontact::Failure&) {
    // a device that does not answer holds nothing
  }
}

// Failures are ignored: the device is lost already.
void Device::give_back() noexcept {
  cudaFree(parts_);
  cudaFree(arrived_);
  cudaFreeHost(seen_);
  for (const Stage& stage : stages_) {
    cudaFreeHost(stage.bytes);
    if (stage.free) cudaEventDestroy(stage.free);
  }
  if (stream_) cudaStreamDestroy(stream_);
  cudaGetLastError();  // the next call begins anew
}

std::size_t free_bytes_of(Index index) {
  std::size_t free = 0, all = 0;
  const Current device(index);
  checked(cudaMemGetInfo(&free, &all), "cudaMemGetInfo");
  return free;
}

void* Device::allocate(std::size_t bytes) {
  void* memory = nullptr;
  checked(cudaMalloc(&memory, bytes), "cudaMalloc");
  return memory;
}

const void* Device::found(const void* callers) const {
  cudaPointerAttributes of{};
  checked(cudaPointerGetAttributes(&of, callers), "cudaPointerGetAttributes");
  const bool there = (of.type == cudaMemoryTypeDevice && of.device == index_) || of.type == cudaMemoryTypeManaged;
  if (!there) not_in_memory(callers, index_);
  return of.devicePointer;
}

void Device::make_parts(std::size_t bytes) {
  if (bytes <= parts_bytes_) return;
  cudaFree(parts_);
  parts_ = nullptr;
  parts_bytes_ = 0;
  parts_ = allocate(bytes);
  parts_bytes_ = bytes;
}

bool Device::staged(std::size_t bytes) {
  if (!team_ || bytes < least_staged) return false;
  for (Stage& stage : stages_) {
    if (!stage.free) checked(cudaEventCreateWithFlags(&stage.free, cudaEventDisableTiming), "cudaEventCreateWithFlags");
    void* memory = stage.bytes;
    if (!memory) checked(cudaHostAlloc(&memory, stage_bytes, cudaHostAllocDefault), "cudaHostAlloc");
    stage.bytes = static_cast<unsigned char*>(memory);
  }
  return true;
}

void Device::upload(void* to, const void* from, std::size_t bytes) {
  if (!staged(bytes)) return copy(to, from, bytes, cudaMemcpyHostToDevice);
  for (std::size_t done = 0, k = 0; done < bytes; done += stage_bytes, ++k) {
    const Stage& stage = stages_[k % 2];
    const std::size_t count = std::min(stage_bytes, bytes - done);
    checked(cudaEventSynchronize(stage.free), "cudaEventSynchronize");
    copy_by(*team_, stage.bytes, static_cast<const unsigned char*>(from) + done, count);
    checked(cudaMemcpyAsync(static_cast<unsigned char*>(to) + done, stage.bytes, count, cudaMemcpyHostToDevice, stream_),
            "cudaMemcpyAsync");
    checked(cudaEventRecord(stage.free, stream_), "cudaEventRecord");
  }
}

void Device::download(void* to, const void* from, std::size_t bytes) {
  if (!staged(bytes)) return copy(to, from, bytes, cudaMemcpyDeviceToHost);
  const auto fetch = [&](std::size_t done, const Stage& stage) {
    checked(cudaMemcpyAsync(stage.bytes, static_cast<const unsigned char*>(from) + done, std::min(stage_bytes, bytes - done),
                            cudaMemcpyDeviceToHost, stream_),
            "cudaMemcpyAsync");
    checked(cudaEventRecord(stage.free, stream_), "cudaEventRecord");
  };
  fetch(0, stages_[0]);
  for (std::size_t done = 0, k = 0; done < bytes; done += stage_bytes, ++k) {
    const Stage& stage = stages_[k % 2];
    if (done + stage_bytes < bytes) fetch(done + stage_bytes, stages_[(k + 1) % 2]);
    checked(cudaEventSynchronize(stage.free), "cudaEventSynchronize");
    copy_by(*team_, static_cast<unsigned char*>(to) + done, stage.bytes, std::min(stage_bytes, bytes - done));
  }
}

void Device::copy(void* to, const void* from, std::size_t bytes, cudaMemcpyKind kind) {
  checked(cudaMemcpyAsync(to, from, bytes, kind, stream_), "cudaMemcpyAsync");
  wait();
}

// The 64-bit planner: the numbers of a torus pass 2^31.
template <class Real> Lines<Real>::Lines(Device& device, const Shape& shape) : shape_(shape) {
  constexpr bool single = std::is_same_v<Real, float>;
  long long length = shape.length, pitch = shape.pitch;
  const long long half = shape.length / 2 + 1;
  checked(cufftCreate(&plan_), "cufftCreate");
  try {
    checked(cufftSetAutoAllocation(plan_, 0), "cufftSetAutoAllocation");
    if (shape.pitch > 0) {
      checked(cufftMakePlanMany64(plan_, 1, &length, &length, pitch, 1, &length, pitch, 1, single ? CUFFT_C2C : CUFFT_Z2Z,
                                  shape.count, &work_bytes_),
              "cufftMakePlanMany64");
    } else {
      long long reals = 2 * half, complex = half;
      const cufftType type = shape.inverse ? (single ? CUFFT_C2R : CUFFT_Z2D) : (single ? CUFFT_R2C : CUFFT_D2Z);
      long long* const in = shape.inverse ? &complex : &reals;
      long long* const out = shape.inverse ? &reals : &complex;
      checked(cufftMakePlanMany64(plan_, 1, &length, in, 1, *in, out, 1, *out, type, shape.count, &work_bytes_),
              "cufftMakePlanMany64");
    }
    checked(cufftSetStream(plan_, device.stream()), "cufftSetStream");
  } catch (...) {
    cufftDestroy(plan_);
    throw;
  }
}

template <class Real> void Lines<Real>::run(Device&, Real* data, void* work) const {
  checked(cufftSetWorkArea(plan_, work), "cufftSetWorkArea");
  const int sign = shape_.inverse ? CUFFT_INVERSE : CUFFT_FORWARD;
  if constexpr (std::is_same_v<Real, float>) {
    auto* const complex = reinterpret_cast<cufftComplex*>(data);
    checked(shape_.pitch > 0 ? cufftExecC2C(plan_, complex, complex, sign)
            : shape_.inverse ? cufftExecC2R(plan_, complex, data)
                             : cufftExecR2C(plan_, data, complex),
            "cufftExec");
  } else {
    auto* const complex = reinterpret_cast<cufftDoubleComplex*>(data);
    checked(shape_.pitch > 0 ? cufftExecZ2Z(plan_, complex, complex, sign)
            : shape_.inverse ? cufftExecZ2D(plan_, complex, data)
                             : cufftExecD2Z(plan_, data, complex),
            "cufftExec");
  }
}

template class Lines<float>;
template class Lines<double>;

}  // namespace rc_cuda
