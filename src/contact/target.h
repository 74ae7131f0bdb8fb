// The step that is to be solved: its target, the scale of its residuals, and the start that it may take.
#pragma once

#include <roughcontact/roughcontact.h>

#include <cstdint>

namespace rc {

class GridProblem;
class StepSurface;

struct Target {
  std::int32_t control = RC_CONTROL_APPROACH;  // or RC_CONTROL_LOAD
  double value = 0;                            // approach [length] or load [force]

  bool by_load() const { return control == RC_CONTROL_LOAD; }
  bool touches(const StepSurface& surface) const;
  // [length] A prescribed approach less the lowest gap; 0 if no point may carry pressure.
  double compression(const StepSurface& surface) const;
};

struct Step {
  Target target;
  rc_const_array p0 = {};  // [points of this process] pressures to start from, in this process's memory; or none
  bool warm = true;        // it may start from earlier steps
};
inline Step step_of(const rc_step& step) { return {{step.control, step.target}, step.p0, step.warm_start != 0}; }

// Throws Error(ARGUMENT, INFEASIBLE). surface: the step's, which need not be the problem's yet. Lengths of both are over the
// compliance.
void check(const Step& step, const GridProblem& problem, const StepSurface& surface, double compliance);

}  // namespace rc
