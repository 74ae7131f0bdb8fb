// Surfaces that mislead whoever looks at coarser grids alone: for the trial of option accuracy.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "library.h"
#include "scene.h"

namespace bench {

struct GoalSurface {
  rc_system system{};
  Field gap;
  std::vector<std::uint8_t> mask;  // empty: every point counts
  double approach = 0;
};

std::vector<std::string> goal_surface_names();

// About n points a side, of unit width and modulus. The seed draws the shape and the approach, and for some seeds an odd size, a
// rectangle, elongated cells, single points or whole parts that do not count, a period.
GoalSurface make_goal_surface(const std::string& name, std::int64_t n, std::uint64_t seed);

}  // namespace bench
