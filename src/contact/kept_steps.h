// Objects that a solver keeps of a history's answers, such as pressures on a device.
#pragma once

#include <roughcontact/plugin.h>

#include <memory>

namespace rc {

struct KeptAnswer {
  const rc_solver* by = nullptr;
  std::shared_ptr<void> object;  // null: nothing is kept

  void* of(const rc_solver& solver) const { return by == &solver ? object.get() : nullptr; }
};

// The kept answers that a start was made of; last is none if it was made of something else. own: kept of the new answer.
struct KeptSteps {
  KeptAnswer last, before;
  double ahead = 0;
  KeptAnswer own;
};

}  // namespace rc
