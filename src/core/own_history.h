// The history that the core hands to solvers of its own, with what plugins need not know.
#pragma once

#include <roughcontact/plugin.h>

namespace rc {

struct OwnHistory : rc_kept_steps {
  // Whether a step may go on without what only makes it faster, where there is no memory for it. Not where other ranks make the
  // same step: all would have to.
  bool may_go_without;
};

}  // namespace rc
