#include "analysis/contact_map.h"

#include <cmath>
#include <limits>

#include "core/error.h"

namespace rc {

namespace {

constexpr std::int64_t most_points = std::numeric_limits<std::int64_t>::max() / 1024;  // arrays over them are addressable

void check_length(double value, const char* name) {
  if (!(std::isfinite(value) && value > 0))
    fail(RC_ERR_ARGUMENT, "rc_system.", name, " = ", value, " must be a positive finite length");
}

void check_grid(const rc_system& system) {
  if (system.op < RC_OPERATOR_HALFSPACE || system.op > RC_OPERATOR_CALLBACK)
    fail(RC_ERR_ARGUMENT, "rc_system.op = ", system.op, " is none of RC_OPERATOR_HALFSPACE, _DENSE, _CALLBACK (1 .. 3)");
  if (system.op == RC_OPERATOR_HALFSPACE && system.boundary != RC_BOUNDARY_FREE && system.boundary != RC_BOUNDARY_PERIODIC)
    fail(RC_ERR_ARGUMENT, "rc_system.boundary = ", system.boundary,
         " is neither RC_BOUNDARY_FREE (1) nor RC_BOUNDARY_PERIODIC (2)");
  if (system.nx < 1 || system.ny < 1) fail(RC_ERR_SHAPE, "nx = ", system.nx, ", ny = ", system.ny, " must both be >= 1");
  if (system.nx > most_points / system.ny)
    fail(RC_ERR_SHAPE, "nx*ny = ", system.nx, " * ", system.ny, " is more than ", most_points, " points");
  check_length(system.hx, "hx");
  check_length(system.hy, "hy");
  if (!std::isnormal(system.hx * system.hy))
    fail(RC_ERR_ARGUMENT, "the cell area hx*hy = ", system.hx, " * ", system.hy,
         " is beyond double precision; choose other units");
}

}  // namespace

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
    if (!std::isfinite(p[i])) fail(RC_ERR_ARGUMENT, "p[", i, "] = ", p[i], " is not finite");
    if (p[i] < 0) fail(RC_ERR_ARGUMENT, "p[", i, "] = ", p[i], " must be >= 0: what pulls is no contact pressure");
  }
}

Edges ContactMap::edges(std::int64_t ix, std::int64_t iy) const {
  Edges found;
  const auto look = [&](std::int64_t x, std::int64_t y, std::int64_t& parallel) {
    const std::int64_t nx = system_.nx, ny = system_.ny;
    if (periodic()) {
      x += x < 0 ? nx : x >= nx ? -nx : 0;
      y += y < 0 ? ny : y >= ny ? -ny : 0;
    }
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
