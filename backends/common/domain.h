// The points of a domain on a grid nx points wide and ny high.
#pragma once

#include <roughcontact/plugin.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace rc_common {

struct Box {
  std::int64_t x = 0, y = 0;    // first column and row on the grid
  std::int64_t nx = 0, ny = 0;  // columns and rows

  std::int64_t points() const { return nx * ny; }
};

// visit(entry, column, row) for the points in order.
template <class Visit> void for_each_point(const rc_domain& domain, std::int64_t nx, const Visit& visit) {
  std::int64_t row = 0, start = 0;  // of the row that the last point was in: a division for each point would be slow
  for (std::int64_t i = 0; i < domain.n; ++i) {
    const std::int64_t point = domain.index ? domain.index[i] : i;
    if (point - start >= nx) {
      row = point / nx;
      start = row * nx;
    }
    visit(i, point - start, row);
  }
}

inline Box bounding_box(const rc_domain& domain, std::int64_t nx, std::int64_t ny) {
  if (!domain.index) return {0, 0, nx, ny};
  std::int64_t left = nx, right = 0;
  for_each_point(domain, nx, [&](std::int64_t, std::int64_t column, std::int64_t) {
    left = std::min(left, column);
    right = std::max(right, column);
  });
  const std::int64_t top = domain.index[0] / nx, bottom = domain.index[domain.n - 1] / nx;
  return {left, top, right - left + 1, bottom - top + 1};
}

// Where each point of the domain lies in its box, row by row; empty if the domain fills the box.
inline std::vector<std::int64_t> places_in(const Box& box, const rc_domain& domain, std::int64_t nx) {
  std::vector<std::int64_t> places;
  if (domain.n == box.points()) return places;
  places.reserve(static_cast<std::size_t>(domain.n));
  for_each_point(domain, nx, [&](std::int64_t, std::int64_t column, std::int64_t row) {
    places.push_back((row - box.y) * box.nx + column - box.x);
  });
  return places;
}

}  // namespace rc_common
