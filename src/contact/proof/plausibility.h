// Remarks on correct results that hint at a blunder in the units or the heights. They refuse nothing.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "contact/surface/pressures.h"
#include "contact/surface/step_surface.h"
#include "contact/system.h"

namespace rc {

// The share of the heights' variance that a plane explains, 0 .. 1. It samples at most 32 x 32 evenly spread points; 0 if
// there are fewer than 16, and on periodic grids if the heights do not jump at the edges.
double plane_share(const StepSurface& surface, std::int64_t nx, std::int64_t ny, bool periodic);

// The outer 2.5 % of a grid with free edges, at least one row or column a side. Empty for grids of fewer than 16 points along a
// side.
class RimPoints {
 public:
  RimPoints(const rc_system& system, std::int64_t first_row);

  // i: a point of this process, whose first row is first_row.
  bool holds(std::size_t i) const {
    if (!any_) return false;
    const auto row = static_cast<std::int64_t>((static_cast<double>(i) + 0.5) * rows_per_point_);  // a division takes longer
    const std::int64_t x = static_cast<std::int64_t>(i) - row * nx_, y = row + first_row_;
    return x < wide_ || x >= nx_ - wide_ || y < high_ || y >= ny_ - high_;
  }
  double share() const;  // of the grid's points

 private:
  std::int64_t nx_, ny_, first_row_, wide_, high_;
  double rows_per_point_;
  bool any_;
};

// The rim's share of the points and of the load, and whether the largest pressure is there.
struct Rim {
  double points = 0, load = 0;
  bool largest = false;
};

// Whether none of the eight points around the one with the largest pressure has a pressure. touching: the entries with one.
bool isolated_peak(const System& system, const StepSurface& surface, const Deflected& answer,
                   std::span<const std::size_t> touching);

// Remarks on a half-space in contact, the gravest first. tilt: plane_share.
std::vector<std::string> doubts(const System& system, double mean_pressure, std::int64_t contacts, double compression,
                                double tilt);
// A remark on how free edges shape the result; "" if they do not, or if a tilt explains it.
// of_punch: its stiffness over that of a flat punch as large as the grid.
std::string edge_effects(double of_punch, const Rim& rim, double tilt);

}  // namespace rc
