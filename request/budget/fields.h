// Fields on a grid of heights: noise, filters, coarser grids, parts. NaN is a point without a height.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/normal_numbers.h"

namespace rc::request {

struct Extent {
  std::int64_t nx, ny;
  double hx, hy;

  std::size_t points() const { return static_cast<std::size_t>(nx * ny); }
};

// The Gaussian filter of ISO 16610-61: halves the amplitude of waves of this length. Missing points and, unless the map wraps,
// the edges lower the weight of what is there. z: [ny*nx]
void low_pass(const Extent& grid, double cutoff, bool wraps, std::span<double> z);

// The linear, symmetric map from independent numbers of variance 1 to numbers of variance 1 with correlation exp(-(r/length)^2),
// cyclic; the identity for length 0.
void correlate(const Extent& grid, double length, std::span<double> z);

inline double natural_logarithm(double x) { return std::log(x); }

// Independent standard normal numbers.
class Normal {
 public:
  // Other numbers than those from which the surface library makes a surface of the same seed.
  explicit Normal(std::uint64_t seed) : numbers_(seed ^ 0x9e3779b97f4a7c15) {}
  double operator()() { return numbers_(); }
  std::int64_t integer(std::int64_t limit);  // uniform in -limit .. limit

 private:
  NormalNumbers<natural_logarithm> numbers_;
};

// Means over blocks of 2 x 2 points; the cells have the whole area of the grid, also of one with odd sides. A block has no height
// if none of its points has.
std::vector<double> halved(const Extent& grid, std::span<const double> z, Extent& coarse);

// Part (kx, ky) of parts x parts that divide the grid; rows and columns that are left over are in none.
std::vector<double> part_of(const Extent& grid, std::span<const double> z, std::int64_t parts, std::int64_t kx, std::int64_t ky,
                            Extent& part);

}  // namespace rc::request
