// Heights of rough and textured surfaces over the unit square, by libroughcontact-surface, and their gaps to a plane.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace failures {

using Field = std::vector<double>;

// Random midpoint displacement as in Bemporad & Paggi (2015): 2^levels points a side.
Field midpoint_surface(std::int64_t levels, double hurst, std::uint64_t seed);

// The distance from a plane through the highest point.
Field gap_below_highest(const Field& heights);
double mean_of(const Field& values);

// Surfaces whose spectrum is a power law, and others, on n x n points.
struct SurfaceClass {
  std::string name;
  double hurst = 0.7;
  double roll_off = 0;               // waves a side; 0: none
  double shortest = 0, longest = 0;  // band of waves a side; 0: none
  double period = 0;                 // of pyramids, in cells; 0: none
  bool noise = false;
  Field heights(std::int64_t n, std::uint64_t seed) const;
};
const std::vector<SurfaceClass>& surface_classes();

}  // namespace failures
