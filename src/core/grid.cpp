#include "core/grid.h"

#include <cmath>

#include "core/error.h"
#include "platform/memory.h"

namespace rc {

namespace {

void check_length(double value, const char* name) {
  if (!(std::isfinite(value) && value > 0))
    fail(RC_ERR_ARGUMENT, "rc_system.", name, " = ", value, " must be a positive finite length; set the cell size");
}

}  // namespace

std::string place(std::int64_t point, std::int64_t nx) { return join("ix=", point % nx, ", iy=", point / nx); }

void check_grid(const rc_system& system) {
  if (system.op < RC_OPERATOR_HALFSPACE || system.op > RC_OPERATOR_CALLBACK)
    fail(RC_ERR_ARGUMENT, "rc_system.op = ", system.op, " is none of RC_OPERATOR_HALFSPACE, _DENSE, _CALLBACK (1 .. 3)");
  if (system.nx < 1 || system.ny < 1)
    fail(RC_ERR_SHAPE, "nx = ", system.nx, ", ny = ", system.ny, " must both be >= 1; set the points along x and y");
  if (system.nx > most_points / system.ny)
    fail(RC_ERR_SHAPE, "nx*ny = ", system.nx, " * ", system.ny, " is more than ", most_points, " points");
  check_length(system.hx, "hx");
  check_length(system.hy, "hy");
  if (!std::isnormal(system.hx * system.hy))
    fail(RC_ERR_ARGUMENT, "the cell area hx*hy = ", system.hx, " * ", system.hy,
         " is beyond double precision; choose other units");
  if (system.op == RC_OPERATOR_HALFSPACE && system.boundary == 0)
    fail(RC_ERR_ARGUMENT,
         "rc_system.boundary is not set: RC_BOUNDARY_PERIODIC (2) for a sample of a larger surface, as a map of ",
         "roughness is; RC_BOUNDARY_FREE (1) for a body that ends at the grid's edges, as a ball or a punch does; ",
         "RC_BOUNDARY_PERIODIC_X (3) or _Y (4) for one that repeats along this axis only");
  if (system.op == RC_OPERATOR_HALFSPACE && (system.boundary < RC_BOUNDARY_FREE || system.boundary > RC_BOUNDARY_PERIODIC_Y))
    fail(RC_ERR_ARGUMENT, "rc_system.boundary = ", system.boundary,
         " is none of RC_BOUNDARY_FREE (1), _PERIODIC (2), _PERIODIC_X (3), _PERIODIC_Y (4)");
}

void check_memory(const rc_system& system, std::int64_t points) {
  const double bytes = static_cast<double>(sizeof(double)) * static_cast<double>(points), machine = rc_platform::machine_bytes();
  if (bytes > machine)
    fail(RC_ERR_MEMORY, "nx*ny = ", system.nx, " * ", system.ny, " points need at least ", static_cast<std::int64_t>(bytes),
         " bytes, this machine has ", static_cast<std::int64_t>(machine), "; use a coarser grid or a smaller domain");
}

}  // namespace rc
