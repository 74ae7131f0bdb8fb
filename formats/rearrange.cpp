#include "formats/rearrange.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "formats/error.h"

namespace rc::formats {

namespace {

struct Cells {
  std::int64_t first, end;
};

// The cells i with from <= (i + 1/2) pitch <= to; a middle on the limit counts, to round-off.
Cells cells_in(double from, double to, double pitch, std::int64_t count) {
  constexpr double round_off = 1e-9;
  const auto n = static_cast<double>(count);
  const double first = std::ceil(from / pitch - 0.5 - round_off), last = std::floor(to / pitch - 0.5 + round_off);
  return {static_cast<std::int64_t>(std::clamp(first, 0.0, n)), static_cast<std::int64_t>(std::clamp(last + 1, 0.0, n))};
}

}  // namespace

void crop(const Region& region, Surface& surface) {
  const Cells x = cells_in(region.x0, region.x1, *surface.hx, surface.nx),
              y = cells_in(region.y0, region.y1, *surface.hy, surface.ny);
  if (x.first >= x.end || y.first >= y.end)
    throw Error("the region ", region.x0, " .. ", region.x1, ", ", region.y0, " .. ", region.y1,
                " has the middle of no cell; the map is ", *surface.hx * static_cast<double>(surface.nx), " x ",
                *surface.hy * static_cast<double>(surface.ny));
  std::vector<double> kept;
  for (std::int64_t iy = y.first; iy < y.end; ++iy) {
    const auto row = surface.heights.begin() + iy * surface.nx;
    kept.insert(kept.end(), row + x.first, row + x.end);
  }
  surface.heights = std::move(kept);
  surface.nx = x.end - x.first;
  surface.ny = y.end - y.first;
}

void mirror(bool along_x, bool along_y, Surface& surface) {
  const auto begin = surface.heights.begin();
  for (std::int64_t iy = 0; along_x && iy < surface.ny; ++iy)
    std::reverse(begin + iy * surface.nx, begin + (iy + 1) * surface.nx);
  for (std::int64_t iy = 0; along_y && iy < surface.ny / 2; ++iy)
    std::swap_ranges(begin + iy * surface.nx, begin + (iy + 1) * surface.nx, begin + (surface.ny - 1 - iy) * surface.nx);
}

}  // namespace rc::formats
