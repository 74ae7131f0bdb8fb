#include "kernel/radial.h"

#include <cmath>

namespace rc::kernel {

RadialSeries::RadialSeries(const std::array<double, terms>& c) : c_(c) {
  // From this distance on the first term left out is at most 1e-16 of the sum.
  for (int j = 0; j < terms; ++j) reach_[j] = 0.25 * std::pow(1e16, 1.0 / (j + 1));
}

void RadialSeries::operator()(double x, double y, Run& out) const {
  const double nearest = x * x + y * y;
  int last = 0;
  while (last + 1 < terms && nearest < reach_[last]) ++last;

  Run k_square, sum{};
  for (int i = 0; i < run_length; ++i) k_square[i] = 0.25 / ((x + i) * (x + i) + y * y);
  for (int j = last; j >= 0; --j)
    for (int i = 0; i < run_length; ++i) sum[i] = sum[i] * k_square[i] + c_[j];
  for (int i = 0; i < run_length; ++i) out[i] = sum[i] * std::sqrt(k_square[i]);
}

void fill_radial(const RadialSeries& series, double factor, double self, const Window& window, double* out) {
  fill(window, out, [&](double x, double y, Run& values) {
    series(x, y, values);
    for (double& value : values) value *= factor;
    if (x == 0 && y == 0) values[0] = self;
  });
}

}  // namespace rc::kernel
