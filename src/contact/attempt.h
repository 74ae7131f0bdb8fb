// An attempt at a step: who watches it, and what earlier attempts have shown.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "contact/choice.h"
#include "contact/monitor.h"
#include "contact/remarks.h"

namespace rc {

struct Attempt {
  Monitor& monitor;
  bool warm = true;                      // coarser grids may also start from earlier steps
  std::vector<std::string> failed = {};  // names of components that "auto" passes over
  Remarks skipped = {};                  // why
  std::int64_t look = 0;                 // the most iterations of a solver that only tries the grid; 0: it solves
};

// Facts of a step that later calls ask for: its explanation and its derivatives.
struct StepOutcome {
  Choice choice = {};
  std::vector<std::string> failed = {};  // components that "auto" passed over
  std::int32_t certified = 0;            // RC_CONTROL_* once the answer on this grid is certified and remembered; 0: it is not
  std::int64_t undecided = -1;           // points of that answer
};

}  // namespace rc
