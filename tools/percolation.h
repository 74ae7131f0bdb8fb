// Whether the contact, or the gap that is left open, reaches across the surface.
#pragma once

#include <cstdint>
#include <vector>

namespace cli {

struct Problem;

struct Crossing {
  bool x = false, y = false;

  const char* text() const { return x ? (y ? "xy" : "x") : y ? "y" : "none"; }
};

// Along x or y, a connected part joins opposite sides of a free grid, or meets itself again around a periodic one. Points are
// connected across edges. contact: points with pressure are looked at, else those without; excluded points are of neither.
Crossing find_crossing(const Problem& problem, const std::vector<double>& pressure, bool contact);

}  // namespace cli
