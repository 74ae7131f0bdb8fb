// Sets of points, operators of the backend, and the products by summing over all sources.
#pragma once

#include <roughcontact/plugin.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "fixtures.h"
#include "support/cmocka.hpp"

namespace split {

using contract::Index;
using contract::largest_difference;
using contract::Vector;

const rc_backend& backend();

struct Grid {
  std::int64_t nx, ny;
  double hx = 1.0, hy = 1.0;
  std::string kernel = "love";

  std::int64_t points() const { return nx * ny; }
};

// H by its coefficients.
class Reference {
 public:
  explicit Reference(const Grid& grid);
  // (H x) at points, x over the domain.
  Vector product(const Index& points, const Index& domain, const Vector& x) const;

 private:
  Grid grid_;
  Vector table_;
};

struct Host {
  contract::StandInHost host{backend()};
  Host(const char* spacing, const char* threads) {
    host.set("split.spacing", spacing);
    host.set("threads", threads);
  }
};

class Operator : Host, public contract::Operator {
 public:
  explicit Operator(const Grid& grid, const char* spacing = "auto", const char* threads = "1");
  // What the operator says about x, one after the other: products in either precision, the overlapping points of a surface, the
  // field.
  Vector every_product(const Vector& x, bool float_first = false);

 private:
  std::int64_t points_;
};

using Random = std::mt19937;
double uniform(Random& random);

// Round islands that cover about `share` of the grid.
Index islands(const Grid& grid, double share, Random& random);
// Positive at about half of the points, 0 at the others.
Vector pressures(const Index& domain, Random& random);
Index every_point(const Grid& grid);
// At most `count` of the points, evenly.
Index some_of(const Index& points, std::size_t count);

double largest(const Vector& values);

extern const std::vector<CMUnitTest> product_tests, screen_tests;

}  // namespace split
