// The host in the place of a device: loops, and FFTW in the place of cuFFT. Sums have the same order as on a device.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <roughcontact/plugin.hpp>
#include <vector>

#include "common/fftw.h"
#include "failure.h"
#include "runtime/index.h"

namespace rc_cuda {

// Part sums by lanes, then halves of these: the order of a device's threads.
template <class Part, class F> Part by_lanes(Index begin, Index end, const F& f) {
  Part lane[lanes];
  for (Index i = begin; i < end; i += lanes)
    for (Index k = 0; k < std::min<Index>(lanes, end - i); ++k) lane[k].add(f(i + k));
  for (int half = lanes / 2; half > 0; half /= 2)
    for (int k = 0; k < half; ++k) lane[k].add(lane[k + half]);
  return lane[0];
}

// The threads of one block, which do everything together.
class Block {
 public:
  template <class F> void each(Index n, const F& f) {
    for (Index i = 0; i < n; ++i) f(i);
  }
  template <class Part, class F> Part reduce(Index n, const F& f) { return by_lanes<Part>(0, n, f); }
  template <class Work> void together(const Work& work) {
    for (int phase = 0; phase < work.phases(); ++phase) each(work.count(phase), [&](Index i) { work(phase, i); });
  }
  // The number that the counter shows, which it then raises: blocks share work by it.
  unsigned take(unsigned* counter) { return (*counter)++; }
  // Its values are not to take registers from those who compute.
  template <class T> void keep_in_memory(T&) {}
};

class Device {
 public:
  Device(const rc_host* host, Index index);

  const rc_host* host() const { return host_; }
  void serve(const rc_host* host, const rc_team*) { host_ = host; }  // the one before may be gone
  Index index() const { return index_; }
  std::size_t free_bytes();
  void* allocate(std::size_t bytes);
  static void release(void* memory) noexcept;
  void upload(void* to, const void* from, std::size_t bytes) {
    call("upload");
    count(bytes, 0);
    std::memcpy(to, from, bytes);
  }
  void download(void* to, const void* from, std::size_t bytes) {
    call("download");
    count(0, bytes);
    std::memcpy(to, from, bytes);
  }
  void clear(void* memory, std::size_t bytes) {
    call("clear");
    std::memset(memory, 0, bytes);
  }
  void wait() { call("wait"); }
  void wait_for_all() { call("wait_for_all"); }
  const void* found(const void* callers) const;

  template <class F> void each(Index n, const F& f) {
    call("each");
    for (Index i = 0; i < n; ++i) f(i);
  }
  template <class Part, class F> Part reduce(Index n, const F& f) {
    call("reduce");
    std::vector<Part> parts(static_cast<std::size_t>((n + piece - 1) / piece));
    for (std::size_t k = 0; k < parts.size(); ++k)
      parts[k] = by_lanes<Part>(static_cast<Index>(k) * piece, std::min(n, static_cast<Index>(k + 1) * piece), f);
    return by_lanes<Part>(0, static_cast<Index>(parts.size()), [&](Index k) { return parts[static_cast<std::size_t>(k)]; });
  }
  template <class Work> void together(const Work& work) {
    call("together");
    Block().together(work);
  }
  // How many blocks a device runs at a time, each with so many bytes of its fastest memory; and how many bytes a block may have.
  template <class Work> Index blocks_at_a_time(std::size_t) { return 2; }
  template <class Work> std::size_t bytes_of_stacks() const { return 0; }  // of all threads that run at a time
  std::size_t most_shared() { return std::size_t{1} << 16; }
  // work(block, its number, its fastest memory). The last block comes first here.
  template <class Work> void blocks(Index count, std::size_t shared, const Work& work) {
    call("blocks");
    std::vector<std::max_align_t> room(shared / sizeof(std::max_align_t) + 1);
    for (Index k = count; k-- > 0;) {
      Block block;
      work(block, k, reinterpret_cast<unsigned char*>(room.data()));
    }
  }
  void call(const char* what);  // fails where a test asks for it
  void count(std::size_t to_device, std::size_t to_host);

 private:
  const rc_host* host_;
  Index index_;
};

class Current {
 public:
  explicit Current(Device& device) { device.call("enter"); }
};

// `rows` lines of `length` reals in rows of 2 (length/2 + 1), transformed in place to length/2 + 1 complex numbers and back; or
// the columns of complex rows. As cuFFT has them.
template <class Real> class Lines {
 public:
  struct Shape {
    Index length, count;
    Index pitch;  // of complex rows; 0: the lines are rows of reals
    bool inverse;
  };

  Lines(Device& device, const Shape& shape);
  std::size_t work_bytes() const { return 0; }
  // data: the first line, aligned as memory of the device is, or one that is whole rows further on.
  void run(Device& device, Real* data, void* work) const;

 private:
  Shape shape_;
  rc_common::OwnedPlan<Real> plan_;  // of one line
};

}  // namespace rc_cuda
