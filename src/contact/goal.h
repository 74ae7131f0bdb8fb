// The accuracy goal: what the option accuracy asks for.
#pragma once

#include "registry/options_handle.h"

namespace rc {

struct Goal {
  double error = 0;  // relative; 0: none
  bool of_area = false;

  // A tolerance far below the goal. Areas need a smaller one: they count points, some of which carry hardly any pressure.
  double tol() const { return error / (of_area ? 1000 : 100); }
};
inline Goal goal_of(const rc_options& options) {
  return {options.real(RC_OPT_ACCURACY), options.text(RC_OPT_ACCURACY_OF) == "area"};
}

}  // namespace rc
