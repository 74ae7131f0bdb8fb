#include "picture_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cli {

namespace {

// Folds every block of points that share a cell; the blocks cover the field exactly, with sizes that differ by at most one.
template <class Fold> Raster reduce(std::int64_t nx, std::int64_t ny, Size size, Fold fold) {
  // gnuplot draws no image of a single row or column, so it is doubled.
  Raster raster{std::clamp<std::int64_t>(nx, 2, size.width), std::clamp<std::int64_t>(ny, 2, size.height), {}};
  raster.values.reserve(static_cast<std::size_t>(raster.nx * raster.ny));
  for (std::int64_t jy = 0; jy < raster.ny; ++jy) {
    const std::int64_t y0 = jy * ny / raster.ny, y1 = std::max((jy + 1) * ny / raster.ny, y0 + 1);
    for (std::int64_t jx = 0; jx < raster.nx; ++jx) {
      const std::int64_t x0 = jx * nx / raster.nx, x1 = std::max((jx + 1) * nx / raster.nx, x0 + 1);
      raster.values.push_back(static_cast<float>(fold(x0, x1, y0, y1)));
    }
  }
  return raster;
}

bool is_spot(const Raster& raster, std::int64_t x0, std::int64_t y0, std::int64_t wide, std::int64_t high) {
  if (x0 < 0 || y0 < 0 || x0 + wide > raster.nx || y0 + high > raster.ny) return false;
  for (std::int64_t y = y0; y < y0 + high; ++y) {
    for (std::int64_t x = x0; x < x0 + wide; ++x) {
      if (!(raster.values[static_cast<std::size_t>(y * raster.nx + x)] > 0)) return false;
    }
  }
  return true;
}

// Whether the cell belongs to a wide x high block of the spot.
bool is_visible(const Raster& raster, std::int64_t x, std::int64_t y, std::int64_t wide, std::int64_t high) {
  for (std::int64_t y0 = y - high + 1; y0 <= y; ++y0) {
    for (std::int64_t x0 = x - wide + 1; x0 <= x; ++x0) {
      if (is_spot(raster, x0, y0, wide, high)) return true;
    }
  }
  return false;
}

}  // namespace

Raster block_mean(const std::vector<double>& field, std::int64_t nx, std::int64_t ny, Size size) {
  return reduce(nx, ny, size, [&](std::int64_t x0, std::int64_t x1, std::int64_t y0, std::int64_t y1) {
    double sum = 0, count = 0;
    for (std::int64_t y = y0; y < y1; ++y) {
      for (std::int64_t x = x0; x < x1; ++x) {
        const double value = field[static_cast<std::size_t>(y * nx + x)];
        if (std::isnan(value)) continue;
        sum += value;
        ++count;
      }
    }
    return sum / count;
  });
}

Raster block_max(const std::vector<double>& field, std::int64_t nx, std::int64_t ny, Size size) {
  return reduce(nx, ny, size, [&](std::int64_t x0, std::int64_t x1, std::int64_t y0, std::int64_t y1) {
    double largest = -std::numeric_limits<double>::infinity();
    for (std::int64_t y = y0; y < y1; ++y) {
      for (std::int64_t x = x0; x < x1; ++x) largest = std::max(largest, field[static_cast<std::size_t>(y * nx + x)]);
    }
    return largest;
  });
}

void grow_small_spots(Raster& raster, Size size) {
  constexpr std::int64_t smallest = 2;  // pixels
  const std::int64_t wide = std::min((smallest * raster.nx + size.width - 1) / size.width, raster.nx);
  const std::int64_t high = std::min((smallest * raster.ny + size.height - 1) / size.height, raster.ny);
  const Raster before = raster;
  for (std::int64_t y = 0; y < raster.ny; ++y) {
    for (std::int64_t x = 0; x < raster.nx; ++x) {
      const float value = before.values[static_cast<std::size_t>(y * raster.nx + x)];
      if (!(value > 0) || is_visible(before, x, y, wide, high)) continue;
      const std::int64_t x0 = std::clamp<std::int64_t>(x - wide / 2, 0, raster.nx - wide);
      const std::int64_t y0 = std::clamp<std::int64_t>(y - high / 2, 0, raster.ny - high);
      for (std::int64_t iy = y0; iy < y0 + high; ++iy) {
        for (std::int64_t ix = x0; ix < x0 + wide; ++ix) {
          float& cell = raster.values[static_cast<std::size_t>(iy * raster.nx + ix)];
          cell = std::max(cell, value);
        }
      }
    }
  }
}

}  // namespace cli
