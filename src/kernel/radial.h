// Kernels of round patches, which depend on the distance alone.
#pragma once

#include <array>

#include "kernel/kernels.h"

namespace rc::kernel {

// sum over j of c_j k^(2j+1), k = 1/(2r), for distances r >= 1 in cells; no c_j larger than c_0.
class RadialSeries {
 public:
  static constexpr int terms = 26;

  explicit RadialSeries(const std::array<double, terms>& c);

  // At the offsets (x, y) .. (x + run_length - 1, y); of no meaning at the origin.
  void operator()(double x, double y, Run& out) const;

 private:
  std::array<double, terms> c_;
  std::array<double, terms> reach_;  // distance squared from which the terms up to j suffice
};

// factor times the series, and `self` at the origin.
void fill_radial(const RadialSeries& series, double factor, double self, const Window& window, double* out);

}  // namespace rc::kernel
