#include "contact/calls/controls.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace rc {

namespace {

double share_of_area(double area, const System& system) {
  if (!std::isfinite(area)) fail(RC_ERR_ARGUMENT, "area = ", area, " is not finite");
  if (area < 0) fail(RC_ERR_INFEASIBLE, "area = ", area, " is negative; the smallest contact area is 0");
  const double whole = nominal_area(system);
  if (area > whole * (1 + 8 * std::numeric_limits<double>::epsilon()))
    fail(RC_ERR_INFEASIBLE, "area = ", area, " is more than the area of the grid, ", whole,
         "; the target is an area [length^2], not a share");
  return std::min(area / whole, 1.0);
}

}  // namespace

void check_control(std::int32_t control, const char* name) {
  if (control != RC_CONTROL_APPROACH && control != RC_CONTROL_LOAD && control != RC_CONTROL_AREA &&
      control != RC_CONTROL_PRESSURE)
    fail(RC_ERR_ARGUMENT, name, " = ", control,
         " is none of RC_CONTROL_APPROACH (1), RC_CONTROL_LOAD (2), RC_CONTROL_AREA (4), RC_CONTROL_PRESSURE (8)");
}

double load_of_pressure(double pressure, const System& system) {
  if (!std::isfinite(pressure)) fail(RC_ERR_ARGUMENT, "mean pressure = ", pressure, " is not finite");
  if (pressure < 0)
    fail(RC_ERR_INFEASIBLE, "mean pressure = ", pressure,
         " is negative; a contact without adhesion cannot pull, the smallest mean pressure is 0");
  return pressure * nominal_area(system);
}

Pressed pressed_by(const rc_step& asked, const System& system) {
  check_control(asked.control, "rc_step.control");
  Pressed pressed{asked, {}};
  if (asked.control == RC_CONTROL_APPROACH || asked.control == RC_CONTROL_LOAD) return pressed;
  pressed.step.control = RC_CONTROL_LOAD;
  if (asked.control == RC_CONTROL_AREA) {
    pressed.share = share_of_area(asked.target, system);
    pressed.step.target = 0;
  } else {
    pressed.step.target = load_of_pressure(asked.target, system);
  }
  return pressed;
}

}  // namespace rc
