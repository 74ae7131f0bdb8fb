#include "request/budget/fields.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rc::request {

namespace {

// exp(-pi (x/width)^2) at x = 0, h, 2 h, ... until it is below 1e-6.
std::vector<double> gaussian(double width, double h, std::int64_t most) {
  const auto reach = std::min(most, static_cast<std::int64_t>(2.1 * width / h));
  std::vector<double> weights;
  for (std::int64_t k = 0; k <= reach; ++k) {
    const double x = static_cast<double>(k) * h / width;
    weights.push_back(std::exp(-std::numbers::pi * x * x));
  }
  return weights;
}

// Symmetric weights over lines of n values that lie `step` apart; values beyond the ends are those of the other end, or 0.
void convolve(std::span<const double> weights, bool wraps, std::int64_t n, std::int64_t step, double* line,
              std::vector<double>& room) {
  const auto reach = std::ssize(weights) - 1;
  room.assign(static_cast<std::size_t>(n + 2 * reach), 0.0);
  for (std::int64_t i = -reach; i < n + reach; ++i) {
    const bool inside = i >= 0 && i < n;
    if (inside || wraps) room[static_cast<std::size_t>(i + reach)] = line[(inside ? i : (i % n + n) % n) * step];
  }
  for (std::int64_t i = 0; i < n; ++i) {
    const double* const middle = room.data() + i + reach;
    double sum = weights[0] * *middle;
    for (std::int64_t k = 1; k <= reach; ++k) sum += weights[static_cast<std::size_t>(k)] * (middle[-k] + middle[k]);
    line[i * step] = sum;
  }
}

void convolve(const Extent& grid, std::span<const double> along_x, std::span<const double> along_y, bool wraps,
              std::span<double> z) {
  std::vector<double> room;
  for (std::int64_t iy = 0; iy < grid.ny; ++iy) convolve(along_x, wraps, grid.nx, 1, z.data() + iy * grid.nx, room);
  for (std::int64_t ix = 0; ix < grid.nx; ++ix) convolve(along_y, wraps, grid.ny, grid.nx, z.data() + ix, room);
}

// Divides by the root of the sum of squares over both sides.
void normalise(std::vector<double>& weights) {
  double sum = weights[0] * weights[0];
  for (std::size_t k = 1; k < weights.size(); ++k) sum += 2 * weights[k] * weights[k];
  for (double& each : weights) each /= std::sqrt(sum);
}

}  // namespace

void low_pass(const Extent& grid, double cutoff, bool wraps, std::span<double> z) {
  const double width = cutoff * std::sqrt(std::numbers::ln2 / std::numbers::pi);
  const std::vector<double> along_x = gaussian(width, grid.hx, grid.nx - 1), along_y = gaussian(width, grid.hy, grid.ny - 1);
  std::vector<double> known(z.size());
  for (std::size_t i = 0; i < z.size(); ++i) known[i] = std::isnan(z[i]) ? 0 : 1;
  const std::vector<double> present = known;
  for (std::size_t i = 0; i < z.size(); ++i)
    if (present[i] == 0) z[i] = 0;
  convolve(grid, along_x, along_y, wraps, z);
  convolve(grid, along_x, along_y, wraps, known);
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = present[i] == 0 ? std::nan("") : z[i] / known[i];
}

void correlate(const Extent& grid, double length, std::span<double> z) {
  if (!(length > 0)) return;
  const double width = length * std::sqrt(std::numbers::pi / 2);
  std::vector<double> along_x = gaussian(width, grid.hx, (grid.nx - 1) / 2),
                      along_y = gaussian(width, grid.hy, (grid.ny - 1) / 2);
  normalise(along_x);
  normalise(along_y);
  convolve(grid, along_x, along_y, true, z);
}

std::int64_t Normal::integer(std::int64_t limit) {
  return static_cast<std::int64_t>(numbers_.uniform() * static_cast<double>(2 * limit + 1)) - limit;
}

std::vector<double> halved(const Extent& grid, std::span<const double> z, Extent& coarse) {
  const std::int64_t nx = grid.nx / 2, ny = grid.ny / 2;
  coarse = {nx, ny, grid.hx * static_cast<double>(grid.nx) / static_cast<double>(nx),
            grid.hy * static_cast<double>(grid.ny) / static_cast<double>(ny)};
  std::vector<double> means(coarse.points());
  for (std::int64_t iy = 0; iy < ny; ++iy)
    for (std::int64_t ix = 0; ix < nx; ++ix) {
      double sum = 0;
      int count = 0;
      for (const std::int64_t at : {std::int64_t{0}, std::int64_t{1}, grid.nx, grid.nx + 1}) {
        const double each = z[static_cast<std::size_t>(2 * iy * grid.nx + 2 * ix + at)];
        if (std::isnan(each)) continue;
        sum += each;
        ++count;
      }
      means[static_cast<std::size_t>(iy * nx + ix)] = count > 0 ? sum / count : std::nan("");
    }
  return means;
}

std::vector<double> part_of(const Extent& grid, std::span<const double> z, std::int64_t parts, std::int64_t kx, std::int64_t ky,
                            Extent& part) {
  part = {grid.nx / parts, grid.ny / parts, grid.hx, grid.hy};
  std::vector<double> found(part.points());
  for (std::int64_t iy = 0; iy < part.ny; ++iy)
    std::copy_n(z.data() + (ky * part.ny + iy) * grid.nx + kx * part.nx, part.nx, found.data() + iy * part.nx);
  return found;
}

}  // namespace rc::request
