// The preconditioner of haar-cg on the device: the mean of two multilevel trees over a box of cells.
#pragma once

#include <cstddef>
#include <vector>

#include "runtime/device.h"
#include "tree_passes.h"
#include "trees/tree_shape.h"

namespace rc_cuda {

class Trees {
 public:
  Trees(Index mx, Index my, const rc::CouplingTable& table);

  std::size_t bytes() const { return bytes_; }
  // The trees live there, [bytes()] aligned as the device's memory is.
  void place(Device& device, unsigned char* memory);
  // Their passes, made by the device or, in_block, by code that runs there.
  TreePasses passes(bool in_block = false) const;

 private:
  std::size_t levels(int tree) const { return levels_[tree].size(); }
  Patterns patterns(float self) const;

  std::vector<Level> levels_[2];
  std::size_t summit_ = 1;  // level from which one block of threads does the rest
  Patterns table_;
  std::size_t bytes_;
  Level* on_device_[2] = {};
  Patterns* table_on_device_ = nullptr;
  const float least_top_;
  float* top_ = nullptr;
  double* level_of_w_ = nullptr;
};

}  // namespace rc_cuda
