// The torus on which products are computed.
#pragma once

#include <cstddef>

#include "common/domain.h"
#include "runtime/index.h"

namespace rc_cuda {

struct Torus {
  Index width, height;
  bool periodic;  // width x height is the periodic grid; else it is padded, so that products do not wrap around

  Index pitch() const { return width / 2 + 1; }  // of rows of complex numbers
  template <class R> std::size_t bytes() const { return static_cast<std::size_t>(2 * pitch() * height) * sizeof(R); }
  std::size_t eigenvalues() const { return static_cast<std::size_t>(pitch() * (height / 2 + 1)); }
  bool operator==(const Torus&) const = default;
};

// The least length from this on without a prime factor above 7.
Index fast_length(Index least);

// The least torus for products between all points of an nx x ny box whose sides have no prime factor above 7. Fails where a side
// or the torus is too large to be counted.
Torus free_torus(Index nx, Index ny);
Torus periodic_torus(Index nx, Index ny);

}  // namespace rc_cuda
