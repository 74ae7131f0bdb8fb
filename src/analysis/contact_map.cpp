#include "analysis/contact_map.h"

#include <cmath>

#include "core/error.h"
#include "core/grid.h"

namespace rc {

Edges& Edges::operator+=(const Edges& more) {
  along_x += more.along_x;
  along_y += more.along_y;
  front += more.front;
  return *this;
}

ContactMap::ContactMap(const rc_system& system, const double* p, const std::uint8_t* mask) : system_(system), p_(p), mask_(mask) {
  check_grid(system);
  if (!p) fail(RC_ERR_ARGUMENT, "p is null");
  for (std::int64_t i = 0; i < points(); ++i) {
    if (!included(i)) continue;
    if (!std::isfinite(p[i])) fail(RC_ERR_ARGUMENT, "p[", i, "] = ", p[i], " is not finite (", place(i, system_.nx), ")");
    if (p[i] < 0)
      fail(RC_ERR_ARGUMENT, "p[", i, "] = ", p[i], " must be >= 0 (", place(i, system_.nx), "): contact pressures do not pull");
  }
}

Edges ContactMap::edges(std::int64_t ix, std::int64_t iy) const {
  Edges found;
  const auto look = [&](std::int64_t x, std::int64_t y, std::int64_t& parallel) {
    const std::int64_t nx = system_.nx, ny = system_.ny;
    if (joins_x()) x += x < 0 ? nx : x >= nx ? -nx : 0;
    if (joins_y()) y += y < 0 ? ny : y >= ny ? -ny : 0;
    const bool inside = x >= 0 && x < nx && y >= 0 && y < ny;
    if (inside && touches(y * nx + x)) return;
    ++parallel;
    if (inside && included(y * nx + x)) ++found.front;
  };
  look(ix - 1, iy, found.along_y);
  look(ix + 1, iy, found.along_y);
  look(ix, iy - 1, found.along_x);
  look(ix, iy + 1, found.along_x);
  return found;
}

}  // namespace rc
