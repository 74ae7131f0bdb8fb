// The heights of a map, checked and without their trend.
#pragma once

#include <roughcontact/surface.h>

#include <cstdint>
#include <vector>

namespace rc::surface {

struct Heights {
  std::int64_t nx, ny;
  double hx, hy;
  bool periodic;
  std::vector<double> z;

  double at(std::int64_t x, std::int64_t y) const { return z[static_cast<std::size_t>(y * nx + x)]; }
  int dimensions() const { return (nx > 1 ? 1 : 0) + (ny > 1 ? 1 : 0); }
  double area() const { return static_cast<double>(nx) * hx * static_cast<double>(ny) * hy; }
};

// Throws an Error that says what is wrong with the map.
Heights read_heights(const rc_surface_map* map);

double variance(const std::vector<double>& values);
double mean_square(const std::vector<double>& values);

// The third or fourth moment over a power of the rms; NaN if all values are 0.
double standard_moment(const std::vector<double>& values, int order);

}  // namespace rc::surface
