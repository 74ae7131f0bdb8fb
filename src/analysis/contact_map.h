// Which cells of a grid are in contact, and the edges around them.
#pragma once

#include <roughcontact/roughcontact.h>

#include <cstdint>

#include "core/boundary.h"

namespace rc {

// Edges between a cell in contact and one that is not.
struct Edges {
  std::int64_t along_x = 0, along_y = 0;  // parallel to x and to y
  std::int64_t front = 0;                 // of both, those towards a cell of the grid that is not masked

  double length(const rc_system& system) const {
    return static_cast<double>(along_x) * system.hx + static_cast<double>(along_y) * system.hy;
  }
  Edges& operator+=(const Edges& more);
};

// A view of the caller's arrays.
class ContactMap {
 public:
  // Throws Error(ARGUMENT, SHAPE). mask may be null: all points.
  ContactMap(const rc_system& system, const double* p, const std::uint8_t* mask);

  const rc_system& system() const { return system_; }
  std::int64_t points() const { return system_.nx * system_.ny; }
  double cell_area() const { return system_.hx * system_.hy; }
  bool joins_x() const { return system_.op == RC_OPERATOR_HALFSPACE && repeats_along_x(system_.boundary); }
  bool joins_y() const { return system_.op == RC_OPERATOR_HALFSPACE && repeats_along_y(system_.boundary); }
  double pressure(std::int64_t i) const { return p_[i]; }
  bool included(std::int64_t i) const { return !mask_ || mask_[i] != 0; }
  bool touches(std::int64_t i) const { return included(i) && p_[i] > 0; }
  // The edges of the cell at column ix, row iy, which must be in contact.
  Edges edges(std::int64_t ix, std::int64_t iy) const;

 private:
  rc_system system_;
  const double* p_;
  const std::uint8_t* mask_;
};

}  // namespace rc
