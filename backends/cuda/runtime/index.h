// Macros and types that code for the device and for the host share.
#pragma once

#include <cstddef>
#include <cstdint>

// RC_CALLED: large code that others call, so that it takes no registers from theirs.
#ifdef __CUDACC__
#define RC_ANYWHERE __host__ __device__
#define RC_CALLED __noinline__
#else
#define RC_ANYWHERE
#define RC_CALLED
#endif

namespace rc_cuda {

using Index = std::int64_t;

// Sums are made of pieces of this many values, each by so many lanes, which are added in halves; then the pieces likewise. So
// they do not depend on the order in which pieces come.
constexpr int lanes = 256, per_lane = 16, piece = lanes * per_lane;

// Arrays within one allocation begin at multiples of 256 bytes.
RC_ANYWHERE constexpr std::size_t rounded(std::size_t bytes) { return (bytes + 255) / 256 * 256; }

template <class T> struct Fill {
  T *to, value;
  RC_ANYWHERE void operator()(Index i) const { to[i] = value; }
};

// n / by and the rest, for n < 2^32: a device divides such numbers much faster.
struct Place {
  Index column, row;
};
RC_ANYWHERE inline Place place_of(Index i, Index columns) {
  const auto n = static_cast<std::uint32_t>(i), by = static_cast<std::uint32_t>(columns);
  return {static_cast<Index>(n % by), static_cast<Index>(n / by)};
}

}  // namespace rc_cuda
