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

  double operator()(double x, double y) const {
    if (far_.reaches(x, y)) return far_.mean_inverse_distance(x, y);
    // The differences of the closed form cancel like (y/side)^2: harmless in the cell's own row and the next one.
    if (y < 1.5 * side_) return rectangle_.closed(x, y, side_);
    double sum = 0;
    for (int i = 0; i < across_.size; ++i) sum += across_.weight[i] * rectangle_.on_line(x, y + across_.node[i]);
    return sum;
  }

 private:
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
  fill(window, out, [&](double x, double y) { return factor * (hx >= hy ? mean(x, y * side) : mean(y, x * side)); });
}

}  // namespace rc::kernel
