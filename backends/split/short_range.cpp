#include "short_range.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace rc_split {

namespace {

// Distance, in cells, of the nearest cells of two tiles that are so many tiles apart.
std::int64_t nearest(std::int64_t tiles) { return std::max<std::int64_t>(0, tiles * side - side + 1); }

std::int64_t cells_within(double distance, double h) { return static_cast<std::int64_t>(distance / h); }

}  // namespace

Range Range::within(double distance, double hx, double hy) {
  Range range;
  range.rows = cells_within(distance, hy);
  range.x = (cells_within(distance, hx) + side - 1) / side;
  range.y = (range.rows + side - 1) / side;
  for (std::int64_t y = 0; y <= range.y; ++y) {
    std::int64_t x = range.x;
    while (x > 0 && std::hypot(hx * static_cast<double>(nearest(x)), hy * static_cast<double>(nearest(y))) > distance) --x;
    range.width.push_back(x);
  }
  return range;
}

Range Range::of_box(std::int64_t tiles_x, std::int64_t tiles_y) {
  return {tiles_x - 1, tiles_y - 1, tiles_y * side, std::vector<std::int64_t>(static_cast<std::size_t>(tiles_y), tiles_x - 1)};
}

// Fills the table with value(x, y) at offsets up to nx - 1, ny - 1, and with 0 beyond.
template <class T> template <class Value> void ShortRange<T>::fill(std::int64_t nx, std::int64_t ny, const Value& value) {
  mx_ = side * range_.x + side - 1;
  my_ = side * range_.y + side - 1;
  ld_ = 2 * mx_ + 1;
  table_.assign(static_cast<std::size_t>(ld_ * (2 * my_ + 1)), T(0));
  for (std::int64_t y = 0; y < ny; ++y)
    for (std::int64_t x = 0; x < nx; ++x) {
      const double v = value(x, y);
      lowest_ = std::min(lowest_, v);
      for (std::int64_t dy : {-y, y})
        for (std::int64_t dx : {-x, x}) table_[static_cast<std::size_t>((my_ + dy) * ld_ + mx_ + dx)] = static_cast<T>(v);
    }
}

template <class T> ShortRange<T>::ShortRange(Kernel& kernel, const Smoothed& smoothed, double rc) {
  const FarField& far = kernel.far();
  const double hx = kernel.hx(), hy = kernel.hy(), limit = rc + far.margin();
  range_ = Range::within(limit, hx, hy);
  const std::int64_t nx = cells_within(limit, hx) + 1, ny = cells_within(limit, hy) + 1;
  const Coefficients& h = kernel.near(nx, ny);
  std::vector<double> rest(static_cast<std::size_t>(nx * ny), 0.0);
  roughcontact::for_each(*kernel.spec().team, ny, true, [&](std::int64_t iy, std::int64_t) {
    for (std::int64_t ix = 0; ix < nx; ++ix) {
      const double x = hx * static_cast<double>(ix), y = hy * static_cast<double>(iy);
      if (x * x + y * y <= limit * limit)
        rest[static_cast<std::size_t>(iy * nx + ix)] = h(ix, iy) - far.smooth(x, y, rc, smoothed);
    }
  });
  fill(nx, ny, [&](std::int64_t x, std::int64_t y) { return rest[static_cast<std::size_t>(y * nx + x)]; });
}

template <class T>
ShortRange<T>::ShortRange(Kernel& kernel, std::int64_t tiles_x, std::int64_t tiles_y) : range_(Range::of_box(tiles_x, tiles_y)) {
  const std::int64_t nx = side * tiles_x, ny = side * tiles_y;
  fill(nx, ny, kernel.near(nx, ny));
}

template class ShortRange<float>;
template class ShortRange<double>;

}  // namespace rc_split
