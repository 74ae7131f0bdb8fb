// u = H p on one grid, for pressures of any sign.
#pragma once

#include <cstdint>
#include <vector>

#include "contact/problem.h"

namespace rc {

class Operator;

// Values over a grid: that of point (ix, iy) is at ix * x + iy * y.
template <class Value> struct GridField {
  Value* values;
  std::int64_t x, y;

  Value& at(std::int64_t ix, std::int64_t iy) const { return values[ix * x + iy * y]; }
};

class Product {
 public:
  Product(const rc_system& system, const rc_options& options);

  // Throws Error(ARGUMENT) on a pressure that is not finite.
  void apply(const GridField<const double>& p, const GridField<double>& u);

 private:
  GridProblem problem_;
  Operator& operator_;
  std::vector<double> p_, u_;
};

}  // namespace rc
