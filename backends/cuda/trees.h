// The preconditioner of haar-cg on the device: the mean of two multilevel trees over a box of cells.
#pragma once

#include <cstddef>
#include <vector>

#include "kernels/trees.h"
#include "runtime/device.h"
#include "solvers/haar_cg/tree_shape.h"

namespace rc_cuda {

class Trees {
 public:
  Trees(Index mx, Index my, const rc::CouplingTable& table);

  std::size_t bytes() const { return bytes_; }
  // The trees live there, [bytes()] aligned as the device's memory is.
  void place(Device& device, unsigned char* memory);

  // state [cells]: which of them are in the free set. surplus: by how much every entry of the table exceeds that of the operator.
  void set_up(Device& device, const std::uint8_t* state, double surplus);
  // z = M g on the free set, 0 elsewhere; without g: z = M 1. keeps_sum: z = M (g - level), the level such that the sum of z is
  // 0.
  template <class R>
  Preconditioned apply(Device& device, const R* g, const std::uint8_t* state, R* z, const R* q, bool keeps_sum);

 private:
  std::size_t levels(int tree) const { return levels_[tree].size(); }
  template <class F> void on_level(Device& device, std::size_t level, const F& f) const {
    const OnLevel<F> work{{levels_[0][level], levels_[1][level]}, f};
    device.each(work.level[0].blocks() + work.level[1].blocks(), work);
  }
  Patterns patterns(float self) const;
  Summit summit() const;

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
