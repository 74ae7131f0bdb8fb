// What a solver keeps of a history's answers where it works, such as pressures on a device.
#pragma once

#include <roughcontact/plugin.h>

#include <memory>

namespace rc {

struct KeptAnswer {
  const rc_solver* by = nullptr;
  std::shared_ptr<void> object;  // null: nothing is kept

  void* of(const rc_solver& solver) const { return by == &solver ? object.get() : nullptr; }
};

// What a start was made of; last is none where that was something else. own: what the solver kept of the answer.
struct KeptSteps {
  KeptAnswer last, before;
  double ahead = 0;
  KeptAnswer own;
};

}  // namespace rc
