// u = H p on one grid, for pressures of any sign.
#pragma once

#include <vector>

#include "contact/problem.h"

namespace rc {

class Operator;

class Product {
 public:
  Product(const rc_system& system, const rc_options& options);

  // p and u may be one array. Throws Error(ARGUMENT) on a pressure that is not finite.
  void apply(const double* p, double* u);

 private:
  GridProblem problem_;
  Operator& operator_;
  std::vector<double> p_, u_;
};

}  // namespace rc
