// What option accuracy asks for.
#pragma once

#include "registry/options_handle.h"

namespace rc {

struct Goal {
  double error = 0;  // relative; 0: none
  bool of_area = false;

  // The tolerance that leaves the goal to the grid. Contact areas count points, some of which carry next to nothing.
  double tol() const { return error / (of_area ? 1000 : 100); }
};
inline Goal goal_of(const rc_options& options) {
  return {options.real(RC_OPT_ACCURACY), options.text(RC_OPT_ACCURACY_OF) == "area"};
}

}  // namespace rc
