// The eigenvalues of H on a small torus, and the roots of its transforms, on the device.
#pragma once

#include <vector>

#include "runtime/memory.h"
#include "small/torus.h"

namespace rc_cuda {

class SmallSpectrum {
 public:
  // Whether the grid's sides have transforms here.
  static bool suits(Index nx, Index ny, bool periodic);
  static std::size_t bytes(Index nx, Index ny, bool periodic);

  // coefficients [ny][nx]: H at non-negative offsets.
  SmallSpectrum(Device& device, Index nx, Index ny, bool periodic, const std::vector<double>& coefficients);
  SmallSpectrum(const SmallSpectrum&) = delete;
  SmallSpectrum& operator=(const SmallSpectrum&) = delete;

  std::size_t bytes() const { return single_.bytes() + double_.bytes(); }
  template <class R> SmallTorus<R> torus() const;

 private:
  template <class R> Memory uploaded(Device& device, const std::vector<double>& eigenvalues) const;

  int nx_, ny_;
  bool periodic_;
  Passes x_, y_;
  Memory single_, double_;
};

}  // namespace rc_cuda
