#include "solvers/haar_cg/nested_start.h"

#include <algorithm>
#include <cmath>
#include <roughcontact/plugin.hpp>

#include "grid/downsample.h"

namespace rc {

namespace {

constexpr std::int64_t coarsest_side = 64;
constexpr std::int64_t chunk = 8192;
constexpr double coarse_tol = 1e-2;             // spreading the pressures to the finer grid loses further digits
constexpr std::int64_t remembered = 256 * 256;  // most points of a coarse grid whose operator is kept for later steps

// Every point takes the pressure of the coarse cell in which it lies.
void spread(const Problem& problem, std::int64_t coarse_nx, const Vector& pressure, std::span<double> p) {
  const rc_grid& grid = *problem.grid();
  const double unit = problem.pressure_unit();
  const auto n = static_cast<std::int64_t>(p.size());
  roughcontact::for_each(problem.team(), (n + chunk - 1) / chunk, n >= 4 * chunk, [&](std::int64_t item, std::int64_t) {
    for (std::int64_t i = item * chunk; i < std::min((item + 1) * chunk, n); ++i) {
      const std::int64_t point = grid.index ? grid.index[i] : i, x = point % grid.nx, y = point / grid.nx;
      p[static_cast<std::size_t>(i)] = pressure[static_cast<std::size_t>(y / 2 * coarse_nx + x / 2)] / unit;
    }
  });
}

}  // namespace

void start_nested(const Problem& problem, std::span<double> p, double& d) {
  const rc_grid& grid = *problem.grid();
  if (std::min(grid.nx, grid.ny) < 2 * coarsest_side) return;
  const auto points = static_cast<std::size_t>(grid.nx * grid.ny);
  const CoarseGrid coarse =
      downsample(grid.nx, grid.ny, {grid.undeformed_gap, points}, {grid.mask, grid.mask ? points : 0}, Filter::mean);
  Vector pressure(static_cast<std::size_t>(coarse.nx * coarse.ny));
  const double length = problem.length_unit();

  rc_coarse request{};
  request.struct_size = sizeof request;
  request.nx = coarse.nx;
  request.ny = coarse.ny;
  request.factor = 2;
  request.undeformed_gap = coarse.gap.data();
  request.mask = coarse.mask.empty() ? nullptr : coarse.mask.data();
  request.control = problem.load_control() ? RC_CONTROL_LOAD : RC_CONTROL_DISPLACEMENT;
  request.approach = grid.approach;
  request.load = problem.load() * problem.pressure_unit() * grid.hx * grid.hy;
  request.solver = "haar-cg";
  request.p = pressure.data();
  request.keep = coarse.nx * coarse.ny <= remembered;
  request.tol = std::max(coarse_tol, problem.tol());
  const rc_status status = problem.coarse(request);
  if (status == RC_STOP_CANCELLED || status == RC_STOP_TIME || status == RC_ERR_MEMORY) throw Leave{status};
  if (status < 0) return;

  spread(problem, coarse.nx, pressure, p);
  if (!problem.load_control()) return;
  // The datum from u = (datum - gap) / length.
  const double datum =
      problem.u() ? grid.undeformed_gap[grid.index ? grid.index[0] : 0] + problem.u()[0] * length : grid.approach;
  d = std::max(0.0, (request.approach - datum) / length);
}

}  // namespace rc
