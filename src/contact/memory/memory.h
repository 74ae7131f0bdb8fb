// A contact remembers its last two certified steps, and how the last step ended. GridContact alone writes it.
#pragma once

#include <roughcontact/history.h>

#include <cstdint>
#include <vector>

#include "contact/attempt.h"
#include "contact/kept_steps.h"
#include "contact/surface/pressures.h"
#include "contact/surface/step_surface.h"

namespace rc {

struct CertifiedStep {
  Pressures pressures;    // empty: there was no step
  double approach = 0;    // [length]
  double load = 0;        // [force]
  bool same_gap = false;  // its surface is that of the current step
  KeptAnswer kept = {};   // of its pressures, by their solver
  double reported = 0;    // [length] its approach in rc_result; the other is over the compliance of the current step
};

struct Memory {
  CertifiedStep last, before;  // the last certified step, and the one before it
  bool indented = false;       // the surface has a plastic indentation, of these steps or earlier ones
  StepOutcome outcome = {};    // of the last step
  std::int64_t surfaces = 0;   // counts the changes of the surface

  void record(CertifiedStep&& step);
  // A step has given a surface. same: it equals that of the step before.
  void surface_is(bool same);
  // Drops the certified steps.
  void forget();

  // Points and pressures of the last step's contact set, as many as there is room for; returns how many there are.
  std::int64_t contact_points(std::int64_t room, std::int64_t* index, double* p) const;
};

// The memory that a state describes. Throws Error(ARGUMENT) on what is not finite or masked. surface: the state's.
Memory memory_of(const rc_state& state, const StepSurface& surface, std::int64_t points);

}  // namespace rc
