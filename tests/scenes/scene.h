// A scene: a system, the surfaces that press on it, the targets of its steps and its options. Its seed determines all of it.
#pragma once

#include <roughcontact/roughcontact.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "support/harness.h"

namespace scenes {

using pairs::Field;
using Real = long double;
using Reals = std::vector<Real>;

struct Surface {
  Field gap;                       // [n] undeformed; NaN at some excluded points
  std::vector<std::uint8_t> mask;  // [n] or empty

  bool included(std::size_t i) const { return mask.empty() || mask[i] != 0; }
};

struct Step {
  double target = 0;
  std::size_t surface = 0;
  bool warm = true;
  Field p0;  // [n] a start, or empty
};

struct Scene {
  std::uint64_t seed = 0;
  rc_system system{};  // without pointers
  std::string kernel = "auto";
  Field matrix;  // [n*n] with RC_OPERATOR_DENSE and _CALLBACK
  std::vector<Surface> surfaces;
  std::int32_t control = RC_CONTROL_APPROACH;
  std::vector<Step> steps;
  double tol = 1e-8;
  std::vector<std::pair<std::string, std::string>> settings;  // other options
  std::string words;                                          // all of this in a line

  std::size_t points() const { return static_cast<std::size_t>(system.nx * system.ny); }
  double cell_area() const { return system.hx * system.hy; }
  bool halfspace() const { return system.op == RC_OPERATOR_HALFSPACE; }
  bool periodic() const { return halfspace() && system.boundary == RC_BOUNDARY_PERIODIC; }
  bool semi_periodic() const {
    return halfspace() && (system.boundary == RC_BOUNDARY_PERIODIC_X || system.boundary == RC_BOUNDARY_PERIODIC_Y);
  }
  // Along the axis across a flow along y or x.
  bool repeats_across(bool along_y) const {
    return periodic() || (halfspace() && system.boundary == (along_y ? RC_BOUNDARY_PERIODIC_X : RC_BOUNDARY_PERIODIC_Y));
  }
  bool hard() const { return system.hardness > 0 && system.hardness < HUGE_VAL; }
  /** Too many points for exact pressures. */
  bool large() const { return points() > 300; }
  bool by_load() const { return control == RC_CONTROL_LOAD || control == RC_CONTROL_PRESSURE; }
};

}  // namespace scenes
