#include "influence.h"

#include <roughcontact/registry.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

namespace fuzz {

namespace {

constexpr Real two_pi = 2 * std::numbers::pi_v<Real>;

// 2/|q| for every wave but the mean, at the offsets of a grid of cells of area 1.
std::vector<Real> periodic_table(std::int64_t nx, std::int64_t ny, Real hx, Real hy) {
  const auto cosines = [](std::int64_t n) {
    std::vector<Real> values;
    for (std::int64_t k = 0; k < n; ++k) values.push_back(std::cos(two_pi * static_cast<Real>(k) / static_cast<Real>(n)));
    return values;
  };
  const std::vector<Real> along_x = cosines(nx), along_y = cosines(ny);
  const auto frequency = [](std::int64_t k, std::int64_t n, Real h) {
    return two_pi * static_cast<Real>(std::min(k, n - k)) / (static_cast<Real>(n) * h);
  };
  std::vector<Real> table(static_cast<std::size_t>(nx * ny));
  for (std::int64_t ky = 0; ky < ny; ++ky)
    for (std::int64_t kx = 0; kx < nx; ++kx) {
      if (kx == 0 && ky == 0) continue;
      const Real value = 2 / std::hypot(frequency(kx, nx, hx), frequency(ky, ny, hy)) / static_cast<Real>(nx * ny);
      // A wave with kx and one with -kx add up to a product of cosines.
      for (std::int64_t iy = 0; iy < ny; ++iy)
        for (std::int64_t ix = 0; ix < nx; ++ix)
          table[static_cast<std::size_t>(iy * nx + ix)] +=
              value * along_x[static_cast<std::size_t>(kx * ix % nx)] * along_y[static_cast<std::size_t>(ky * iy % ny)];
    }
  return table;
}

}  // namespace

std::optional<std::vector<Real>> influence(const Scene& scene) {
  const rc_system& s = scene.system;
  if (s.op != RC_OPERATOR_HALFSPACE) return std::vector<Real>(scene.matrix.begin(), scene.matrix.end());
  const Real cell = std::sqrt(static_cast<Real>(s.hx)) * std::sqrt(static_cast<Real>(s.hy));
  const Real hx = static_cast<Real>(s.hx) / cell, hy = static_cast<Real>(s.hy) / cell;
  const std::size_t n = scene.points();
  std::vector<Real> table;
  if (s.boundary == RC_BOUNDARY_PERIODIC) {
    table = periodic_table(s.nx, s.ny, hx, hy);
  } else {
    const std::string kernel = scene.option(RC_OPT_KERNEL, "auto");
    Reals values(n);
    const auto x = static_cast<double>(hx), y = s.hx == s.hy ? x : static_cast<double>(hy);
    if (rc_kernel_coefficients(kernel == "auto" ? "love" : kernel.c_str(), x, y, s.nx, s.ny, values.data()) != RC_OK) return {};
    table.assign(values.begin(), values.end());
  }
  for (const Real value : table)
    if (!std::isfinite(value)) return {};  // cells beyond any shape
  for (Real& value : table) value *= cell / static_cast<Real>(s.modulus);
  std::vector<Real> matrix(n * n);
  const auto nx = s.nx, points = static_cast<std::int64_t>(n);
  for (std::int64_t i = 0; i < points; ++i)
    for (std::int64_t j = 0; j < points; ++j)
      matrix[static_cast<std::size_t>(i * points + j)] =
          table[static_cast<std::size_t>(std::abs(i / nx - j / nx) * nx + std::abs(i % nx - j % nx))];
  return matrix;
}

}  // namespace fuzz
