#include "contact/slopes/punch_stiffness.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/error.h"

namespace rc {

namespace {

constexpr std::int64_t cells = 16;  // along each side

// The force of the pressures x with H x = 1 on side x side cells, in units of the dimensionless system. They are symmetric about
// both axes, so those of a quarter are the unknowns, and the sum of x is the square of the Cholesky factor's solution of L y = 1.
double unit_stiffness(const System& system, std::int64_t side) {
  rc_system grid = system.unit;
  const double shrink_x = static_cast<double>(grid.nx) / static_cast<double>(side);
  const double shrink_y = static_cast<double>(grid.ny) / static_cast<double>(side);
  grid.hx *= shrink_x;
  grid.hy *= shrink_y;
  if (system.kernel.influence->has(RC_KERNEL_SQUARE)) grid.hx = grid.hy = std::sqrt(grid.hx * grid.hy);
  grid.nx = grid.ny = side;
  std::vector<double> at(static_cast<std::size_t>(side * side));
  system.kernel.influence->window(grid, {0, 0, side, side}, at.data());

  const std::int64_t half = side / 2, n = half * half;
  const auto entry = [&](std::int64_t i, std::int64_t j) {
    const std::int64_t xi = i % half, yi = i / half, xj = j % half, yj = j / half;
    double sum = 0;
    for (const std::int64_t x : {xj, side - 1 - xj})
      for (const std::int64_t y : {yj, side - 1 - yj})
        sum += at[static_cast<std::size_t>(std::abs(y - yi) * side + std::abs(x - xi))];
    return sum;
  };
  std::vector<double> factor(static_cast<std::size_t>(n * n)), y(static_cast<std::size_t>(n));
  const auto l = [&](std::int64_t i, std::int64_t j) -> double& { return factor[static_cast<std::size_t>(i * n + j)]; };
  double sum = 0;
  for (std::int64_t i = 0; i < n; ++i) {
    double right = 1;
    for (std::int64_t j = 0; j <= i; ++j) {
      double value = entry(i, j);
      for (std::int64_t k = 0; k < j; ++k) value -= l(i, k) * l(j, k);
      l(i, j) = i == j ? std::sqrt(value) : value / l(j, j);
      if (j < i) right -= l(i, j) * y[static_cast<std::size_t>(j)];
    }
    y[static_cast<std::size_t>(i)] = right / l(i, i);
    sum += y[static_cast<std::size_t>(i)] * y[static_cast<std::size_t>(i)];
  }
  return 4 * sum * shrink_x * shrink_y;
}

}  // namespace

double punch_stiffness(const System& system) {
  if (!system.halfspace() || system.periodic()) return std::numeric_limits<double>::quiet_NaN();
  try {
    // The error falls in proportion to the cells' side, because pressure is singular at the edges.
    const double sum = 2 * unit_stiffness(system, cells) - unit_stiffness(system, cells / 2);
    return sum * system.cell_area() / system.length_per_pressure;
  } catch (const Error&) {
    return std::numeric_limits<double>::quiet_NaN();  // a kernel from outside may know these cells only
  }
}

}  // namespace rc
