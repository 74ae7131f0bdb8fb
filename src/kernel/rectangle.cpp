#include "kernel/rectangle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/multipole.h"

namespace rc::kernel {

namespace {

class MeanInverseDistance {
 public:
  MeanInverseDistance(const Rectangle& rectangle, double side)
      : rectangle_(rectangle), side_(side), across_(rectangle.density(side)), far_(rectangle.density(1), across_) {}

  // At (x + i step_x, y + i step_y), in units of the long side; the steps may not be negative.
  void operator()(double x, double y, double step_x, double step_y, Run& out) const {
    Run square, t;
    for (int i = 0; i < run_length; ++i) {
      const double at_x = x + i * step_x, at_y = y + i * step_y;
      square[i] = at_x * at_x + at_y * at_y;
      t[i] = (at_x - at_y) * (at_x + at_y) / square[i];
    }
    far_.mean_inverse_distance(square, t, square[0], out);
    for (int i = 0; i < run_length && !far_.reaches(square[i]); ++i) out[i] = near(x + i * step_x, y + i * step_y);
  }

 private:
  double near(double x, double y) const {
    // The differences of the closed form cancel like (y/side)^2: harmless in the cell's own row and the next one.
    if (y < 1.5 * side_) return rectangle_.closed(x, y, side_);
    double sum = 0;
    for (int i = 0; i < across_.size; ++i) sum += across_.weight[i] * rectangle_.on_line(x, y + across_.node[i]);
    return sum;
  }

  Rectangle rectangle_;
  double side_;
  Density across_;
  Multipole far_;
};

}  // namespace

void fill_rectangle(const Rectangle& rectangle, double hx, double hy, const Window& window, double* out) {
  const double longer = std::max(hx, hy), side = std::min(hx, hy) / longer;
  const MeanInverseDistance mean(rectangle, side);
  const double factor = longer * side / std::numbers::pi;
  fill(window, out, [&](double x, double y, Run& values) {
    if (hx >= hy)
      mean(x, y * side, 1, 0, values);
    else
      mean(y, x * side, 0, side, values);
    for (double& value : values) value *= factor;
  });
}

}  // namespace rc::kernel
