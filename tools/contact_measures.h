// What a step's pressures and gaps look like, beyond what the library's result has.
#pragma once

#include <cstdint>
#include <vector>

#include "percolation.h"

namespace cli {

struct Problem;

// Pressures and deformed gaps of a step and, where there is a hardness, the plastic indentation after it.
struct Fields {
  Fields(std::size_t points, bool yields) : pressure(points), gap(points), indentation(yields ? points : 0) {}
  std::vector<double> pressure, gap, indentation;
};

struct ContactMeasures {
  double max_pressure = 0;    // [Pa]
  double mean_gap = 0;        // of the points that are not excluded [m]
  double corrected_area = 0;  // less what partly touching cells add [m^2]
  std::int64_t patches = 0;   // connected across edges
  double largest_patch = 0;   // its area [m^2]
  Crossing contact, gap;
};

ContactMeasures measure(const Problem& problem, const Fields& fields);

}  // namespace cli
