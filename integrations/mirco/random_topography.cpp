#include <algorithm>
#include <cmath>
#include <random>

#include "input.h"

namespace MIRCO {

Heights random_topography(int resolution, double deviation, double hurst, unsigned seed) {
  std::default_random_engine engine(seed);
  std::normal_distribution<double> normal(0.0, 1.0);
  const double ratio = std::pow(2.0, 0.5 * hurst);
  double size = deviation * ratio;
  const std::int64_t last = std::int64_t{1} << resolution;
  Heights z{last + 1, std::vector<double>(static_cast<std::size_t>((last + 1) * (last + 1)), 0.0)};
  const auto inside = [&](std::int64_t row, std::int64_t column, std::int64_t half) {  // from the neighbours in both directions
    z(row, column) = (z(row, column + half) + z(row, column - half) + z(row + half, column) + z(row - half, column)) / 4 +
                     size * normal(engine);
  };

  for (std::int64_t step = last, half = last / 2; half > 0; step = half, half /= 2) {
    size /= ratio;
    for (std::int64_t row = half; row < last; row += step)
      for (std::int64_t column = half; column < last; column += step)
        z(row, column) = (z(row + half, column + half) + z(row + half, column - half) + z(row - half, column + half) +
                          z(row - half, column - half)) /
                             4 +
                         size * normal(engine);
    size /= ratio;
    for (std::int64_t at = half; at < last; at += step) {  // the four edges
      z(at, 0) = (z(at + half, 0) + z(at - half, 0) + z(at, half)) / 3 + size * normal(engine);
      z(at, last) = (z(at + half, last) + z(at - half, last) + z(at, last - half)) / 3 + size * normal(engine);
      z(0, at) = (z(0, at + half) + z(0, at - half) + z(half, at)) / 3 + size * normal(engine);
      z(last, at) = (z(last, at + half) + z(last, at - half) + z(last - half, at)) / 3 + size * normal(engine);
    }
    for (std::int64_t row = half; row < last; row += step)
      for (std::int64_t column = step; column < last; column += step) inside(row, column, half);
    for (std::int64_t row = step; row < last; row += step)
      for (std::int64_t column = half; column < last; column += step) inside(row, column, half);
  }
  const double lowest = *std::min_element(z.values.begin(), z.values.end());
  for (double& height : z.values) height -= lowest;
  return z;
}

}  // namespace MIRCO
