#include "contact/target.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/problem.h"
#include "core/array.h"
#include "core/certificate_terms.h"
#include "core/error.h"
#include "core/grid.h"

namespace rc {

namespace {

constexpr double least_depth = 1e-30;  // over the gap's range; periodic solvers work on all points, in single precision too

}  // namespace

void check(const Step& step, const GridProblem& problem, const StepSurface& surface, double compliance) {
  const System& system = problem.system;
  const double target = step.target.value;
  const bool by_load = step.target.by_load(), by_approach = !by_load;
  if (!std::isfinite(target)) fail(RC_ERR_ARGUMENT, "rc_step.target = ", target, " is not finite");
  if (by_load && target < 0)
    fail(RC_ERR_INFEASIBLE, "load = ", target, " is negative; a contact without adhesion cannot pull, the smallest load is 0");
  if (by_load && target > 0 && surface.range().included == 0)
    fail(RC_ERR_INFEASIBLE, "load = ", target, " but every point is excluded by the mask");
  const double most = system.hardness * system.cell_area() * static_cast<double>(surface.range().included);
  if (by_load && target > most * (1 + 8 * std::numeric_limits<double>::epsilon()))
    fail(RC_ERR_INFEASIBLE, "load = ", target, " is more than hardness times the area of the ", surface.range().included,
         " points that may carry pressure, ", most, "; prescribe less load, or allow more points");
  const double depth = target - surface.lowest();
  if (by_approach && !system.capped() && system.periodic() && surface.range().whole &&
      beyond_mean_plane(depth, surface.moments().mean))
    fail(RC_ERR_INFEASIBLE, "approach = ", compliance * target, " reaches the mean plane of the gap, ",
         compliance * (surface.lowest() + surface.moments().mean),
         ": with periodic boundaries the load is not determined there; prescribe the load");
  if (by_approach && system.periodic() && depth > 0 && depth < least_depth * surface.range().width())
    fail(RC_ERR_ARGUMENT, "approach = ", compliance * target, " is above the lowest gap by ", compliance * depth, ", less than ",
         least_depth, " of the gap's range, ", compliance * surface.range().width(), "; check the units, or prescribe the load");
  if (surface.range().included > 0 &&
      !(std::isfinite(surface.range().highest - surface.lowest()) && (by_load || std::isfinite(depth))))
    fail(RC_ERR_ARGUMENT, "the gap's range, ", compliance * surface.lowest(), " .. ", compliance * surface.range().highest,
         ", and the target ", by_load ? target : compliance * target, " are too far apart for double precision");
  problem.rows().on_all([&] {
    for (std::int64_t i = 0; step.p0.data && i < problem.own_points(); ++i)
      if (const double p = value_at(step.p0, static_cast<std::size_t>(i)); !std::isfinite(p))
        fail(RC_ERR_ARGUMENT, "rc_step.p0[", i, "] = ", p, " is not finite (",
             place(problem.rows().first() * system.given.nx + i, system.given.nx), ")");
  });
}

bool Target::touches(const StepSurface& surface) const {
  if (surface.range().included == 0) return false;
  return by_load() ? value != 0 : value > surface.lowest();
}

double Target::compression(const StepSurface& surface) const {
  return surface.range().included > 0 ? value - surface.lowest() : 0;
}

}  // namespace rc
