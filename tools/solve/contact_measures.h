// Measures of a step's pressures that the library's result does not have.
#pragma once

#include <roughcontact/analysis.h>

#include <cstdint>
#include <vector>

namespace cli {

struct Problem;

// Pressures and deformed gaps of a step and, if there is a hardness, the plastic indentation after it.
struct Fields {
  Fields(std::size_t points, const rc_system& system)
      : pressure(points),
        gap(points),
        indentation(system.hardness > 0 ? points : 0),
        creep(system.creep_terms > 0 ? (static_cast<std::size_t>(system.creep_terms) + 1) * points : 0) {}
  std::vector<double> pressure, gap, indentation, creep;  // the last two after a step; empty: there is none
};

struct ContactMeasures {
  double corrected_area = 0;  // less what partly touching cells add [m^2]
  std::int64_t patches = 0;   // connected across edges
  double largest_patch = 0;   // its area [m^2]
  std::int32_t contact_crosses = RC_CROSSES_NONE, gap_crosses = RC_CROSSES_NONE;
};

ContactMeasures measure(const Problem& problem, const std::vector<double>& pressure);

}  // namespace cli
