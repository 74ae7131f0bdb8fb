// The controls that a caller names. A step itself has an approach or a load.
#pragma once

#include <roughcontact/roughcontact.h>

#include <cstdint>
#include <optional>

#include "contact/system.h"

namespace rc {

// Throws Error(ARGUMENT) for a number that is no RC_CONTROL_*. name: "rc_step.control".
void check_control(std::int32_t control, const char* name);

inline double nominal_area(const System& system) { return static_cast<double>(system.points()) * system.cell_area(); }
// [force] The load of a mean pressure. Throws Error(ARGUMENT, INFEASIBLE).
double load_of_pressure(double pressure, const System& system);

struct Pressed {
  rc_step step;                 // by approach or load
  std::optional<double> share;  // of the nominal area, which a load is to be searched for; the step has load 0
};
// Throws Error(ARGUMENT, INFEASIBLE).
Pressed pressed_by(const rc_step& asked, const System& system);

}  // namespace rc
