#include "contact/step/target.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/certificate_terms.h"
#include "core/error.h"

namespace rc {

namespace {

constexpr double least_depth = 1e-30;  // over the gap's range; periodic solvers work on all points, in single precision too

}  // namespace

void check_target(const rc_step& step, const Workspace& work, const StepSurface& surface) {
  const bool by_load = step.control == RC_CONTROL_LOAD, by_approach = step.control == RC_CONTROL_APPROACH;
  if (!by_load && !by_approach)
    fail(RC_ERR_ARGUMENT, "rc_step.control = ", step.control, " is neither RC_CONTROL_APPROACH (1) nor RC_CONTROL_LOAD (2)");
  if (!std::isfinite(step.target)) fail(RC_ERR_ARGUMENT, "rc_step.target = ", step.target, " is not finite");
  if (by_load && step.target < 0)
    fail(RC_ERR_INFEASIBLE, "load = ", step.target,
         " is negative; a contact without adhesion cannot pull, the smallest load is 0");
  if (by_load && step.target > 0 && surface.included_points() == 0)
    fail(RC_ERR_INFEASIBLE, "load = ", step.target, " but every point is excluded by the mask");
  const double most = work.system.hardness * work.system.cell_area() * static_cast<double>(surface.included_points());
  if (by_load && step.target > most * (1 + 8 * std::numeric_limits<double>::epsilon()))
    fail(RC_ERR_INFEASIBLE, "load = ", step.target, " is more than hardness times the area of the ", surface.included_points(),
         " points that may carry pressure, ", most, "; prescribe less load, or allow more points");
  if (by_approach && !work.system.capped() && work.system.periodic() && surface.whole() &&
      beyond_mean_plane(step.target - surface.lowest(), surface.mean_height()))
    fail(RC_ERR_INFEASIBLE, "approach = ", step.target, " reaches the mean plane of the gap, ", surface.mean(),
         ": with periodic boundaries the load is not determined there; prescribe the load");
  if (const double depth = step.target - surface.lowest();
      by_approach && work.system.periodic() && depth > 0 && depth < least_depth * surface.range())
    fail(RC_ERR_ARGUMENT, "approach = ", step.target, " is above the lowest gap by ", depth, ", less than ", least_depth,
         " of the gap's range, ", surface.range(), "; check the units, or prescribe the load");
  if (surface.included_points() > 0 &&
      !(std::isfinite(surface.highest() - surface.lowest()) && (by_load || std::isfinite(step.target - surface.lowest()))))
    fail(RC_ERR_ARGUMENT, "the gap's range, ", surface.lowest(), " .. ", surface.highest(), ", and the target ", step.target,
         " are too far apart for double precision");
  on_all(work.ranks(), [&] {
    for (std::int64_t i = 0; step.p0 && i < work.own_points(); ++i)
      if (!std::isfinite(step.p0[i])) fail(RC_ERR_ARGUMENT, "rc_step.p0[", i, "] = ", step.p0[i], " is not finite");
  });
}

bool nothing_touches(const rc_step& step, const Workspace& work) {
  if (work.surface.included_points() == 0) return true;
  return step.control == RC_CONTROL_LOAD ? step.target == 0 : step.target <= work.surface.lowest();
}

double compression_of(const rc_step& step, const Workspace& work) {
  return work.surface.included_points() > 0 ? step.target - work.surface.lowest() : 0;
}

// The scale follows from the problem alone: an answer must not set the scale that it is judged by. Periodic, load control: in
// full contact the compression may vanish under any load. The scale is then at least a quarter of mean pressure times
// length_per_pressure, or what the kernel deflects a cell by if that is less; the library's kernels deflect it by more, if it is
// up to 100 times as long as wide. Periodic, approach control: gaps under pressure as large as the mean gap would leave the
// load open, so tol times the scale is half of it at most.
double residual_scale(const rc_step& step, const Workspace& work, double compression) {
  const System& system = work.system;
  if (!system.periodic()) return compression;
  if (step.control == RC_CONTROL_LOAD) {
    const double mean_pressure = step.target / system.cell_area() / static_cast<double>(system.points());
    return periodic_scale_by_load(compression, system.least_deflection * system.length_per_pressure * mean_pressure);
  }
  const double mean_gap = std::abs(work.surface.mean_height() - compression);  // d may pass the mean plane if p has a cap
  return work.surface.whole() ? periodic_scale_by_approach(compression, mean_gap, work.options.real(RC_OPT_TOL)) : compression;
}

}  // namespace rc
