// Pressures of a history's steps, which stay on the device for the steps that start from them.
#pragma once

#include <roughcontact/plugin.h>

#include <cstddef>

#include "common/domain.h"
#include "engine.h"

namespace rc_cuda {

// Pressures to start a step from, in its units.
struct Start {
  rc_common::Box box;
  double unit, cap;  // the pressure that is 1 in p [force/length^2], and the largest p
  double* p;         // device memory, [box]
};

class History {
 public:
  // index: of the device.
  History(const rc_problem& problem, Index index);

  std::size_t bytes() const;  // that are kept
  // Others need the memory: what is kept goes, and the host's copies serve.
  void give_way();
  // Writes the start, in the bits that the host has. False where it was not kept: nothing is written.
  bool write(Device& device, const Start& start) const;
  // Keeps the answer, where there is memory below the limit for it besides `held` [bytes].
  void keep(Device& device, const Start& answer, std::size_t held, double limit);

 private:
  struct Kept;

  const rc_kept_steps* const given_;  // null: nothing is kept
  const Index index_;
  Kept *last_ = nullptr, *before_ = nullptr;
};

}  // namespace rc_cuda
