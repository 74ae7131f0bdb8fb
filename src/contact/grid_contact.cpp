#include "contact/grid_contact.h"

#include <cmath>
#include <new>
#include <utility>
#include <vector>

#include "contact/proof/result.h"
#include "contact/step/solve.h"
#include "contact/step/target.h"
#include "core/error.h"

namespace rc {

namespace {

const Monitor& monitor_of(void* user) { return *static_cast<const Monitor*>(user); }

std::int32_t ask(const rc_progress*, void* monitor) { return monitor_of(monitor).ask() != RC_OK; }

std::int32_t pass_on(const rc_progress* progress, void* monitor) {
  return monitor_of(monitor).ask() != RC_OK || monitor_of(monitor).report(*progress) != 0;
}

// A surface, and the indentation that is in its gap.
struct IndentedSurface {
  StepSurface surface;
  Indentation indentation;
};

StepSurface surface_with(const Indentation& indentation, std::span<const std::uint8_t> mask, const Workspace& work) {
  const rc_system& system = work.system.given;
  const std::vector<double> gap = indentation.indented();
  return StepSurface({system.nx, work.own_rows(), gap, mask, false}, work.team(), work.ranks());
}

// The gap that a step gives; empty where it gives none.
GapValues given_gap(const rc_step& step, std::size_t n) {
  if (step.undeformed_gap) return std::span(step.undeformed_gap, n);
  if (step.undeformed_gap_single) return std::span(step.undeformed_gap_single, n);
  return {};
}

// The surface that this step describes; nothing where it keeps that of the step before.
std::optional<IndentedSurface> given_surface(const rc_step& step, const Workspace& work, const Indentation& indentation) {
  const auto n = static_cast<std::size_t>(work.own_points());
  if (step.undeformed_gap && step.undeformed_gap_single)
    fail(RC_ERR_ARGUMENT, "rc_step.undeformed_gap and rc_step.undeformed_gap_single are both given; set one of them to null");
  const GapValues gap = given_gap(step, n);
  const bool given_anew = step.undeformed_gap || step.undeformed_gap_single;
  if (!given_anew && work.surface.empty()) fail(RC_ERR_ARGUMENT, "rc_step.undeformed_gap is null and no earlier step gave one");
  if (!given_anew && !step.mask) return std::nullopt;
  const std::span<const std::uint8_t> mask(step.mask, step.mask ? n : 0);
  if (!indentation.none()) {
    IndentedSurface given{{}, given_anew ? indentation.of(gap) : indentation};
    given.surface = surface_with(given.indentation, mask, work);
    return given;
  }
  const rc_system& system = work.system.given;
  const GivenSurface given{system.nx, work.own_rows(), given_anew ? gap : work.surface.gap(), mask,
                           given_anew && step.borrow != 0};
  return IndentedSurface{StepSurface(given, work.team(), work.ranks()), {}};
}

}  // namespace

void GridContact::watched_by(const Monitor& monitor, bool report) {
  progress_ = {report ? pass_on : ask, const_cast<Monitor*>(&monitor), 1};
}

Monitor GridContact::monitor() const {
  return {cancelled_, progress_, work_.options.real(RC_OPT_TIME_LIMIT), work_.options.integer(RC_OPT_MAX_ITER)};
}

// Puts what the last step has left into the surface, which counts as the same.
void GridContact::indent() {
  if (work_.ranks() ? !work_.ranks()->any(!overlap_.empty()) : overlap_.empty()) return;
  Indentation next;
  on_all(work_.ranks(), [&] { next = indentation_.with(overlap_, work_.surface.gap()); });
  work_.surface = surface_with(next, work_.surface.masks(), work_);
  fill_masked();
  indentation_ = std::move(next);
  overlap_ = {};
}

// With ranks every point is an unknown.
void GridContact::fill_masked() {
  if (!work_.ranks()) return;
  const rc_system& s = work_.system.given;
  const double side = std::max(s.hx * static_cast<double>(s.nx), s.hy * static_cast<double>(s.ny));
  on_all(work_.ranks(), [&] { work_.surface.fill_masked(side); });
}

void GridContact::write_indentation(std::span<double> to) const {
  indentation_.write(to);
  overlap_.add_to(to);
}

void GridContact::begin(const rc_step& step) {
  if (work_.ranks()) work_.ranks()->forget_stop();
  indent();
  std::optional<IndentedSurface> given = given_surface(step, work_, indentation_);
  check_target(step, work_, given ? given->surface : work_.surface);
  if (given) {
    adopt(std::move(given->surface));
    indentation_ = std::move(given->indentation);
  }
  memory_.indented = !indentation_.none();
  if (work_.options.integer(RC_OPT_RESUMABLE) != 0) forget_operators();
  work_.solver_grids.begin_step();
  work_.record = {};
  work_.record.warm = step.warm_start != 0;
  work_.record.products_before = work_.products();
}

rc_status GridContact::solve_begun(const rc_step& step, Monitor& monitor, rc_result& result, std::optional<Estimate> nearer) {
  const Rest after(work_);
  Finished finished = nothing_touches(step, work_) ? certified_result(work_, step, {}, monitor, result)
                                                   : solve_step(work_, memory_, step, monitor, result, std::move(nearer));
  if (finished.status == RC_OK) {
    remember(std::move(finished), result);
    work_.record.certified = step.control;
    work_.record.undecided = result.undecided;
  }
  return result.status;
}

rc_status GridContact::solve(const rc_step& step, rc_result& result) {
  begin(step);
  Monitor watch = monitor();
  return solve_begun(step, watch, result);
}

rc_status GridContact::certify(const rc_step& step, rc_result& result) {
  if (!result.p && !result.p_single) fail(RC_ERR_ARGUMENT, "rc_result.p is null: the pressures to certify are expected there");
  const StepSurface& last = work_.surface;
  on_all(work_.ranks(), [&] {
    for (std::int64_t k = 0; k < work_.own_points(); ++k) {
      const auto i = static_cast<std::size_t>(k);
      const double p = given_pressure(result, i);
      if (!std::isfinite(p)) fail(RC_ERR_ARGUMENT, "rc_result.p[", i, "] = ", p, " is not finite");
      if (p != 0 && (step.mask ? step.mask[i] == 0 : given_gap(step, 1).empty() && !last.empty() && !last.included(i)))
        fail(RC_ERR_ARGUMENT, "rc_result.p[", i, "] = ", p, " but this point is excluded by the mask");
    }
  });
  begin(step);
  const Rest after(work_);
  return certify_given(work_, step, Monitor(cancelled_, {}, 0, 1), result).status;
}

rc_status GridContact::retrace(const rc_step& step, double compression, rc_result& result) {
  begin(step);
  const Rest after(work_);
  Finished finished = certify_given(work_, step, Monitor(cancelled_, {}, 0, 1), result, compression);
  if (leaves_indentation_) overlap_ = std::move(finished.overlap);
  return finished.status;
}

void GridContact::remember(Finished&& finished, const rc_result& result) {
  Pressures kept;
  try {
    kept = finished.pressures.positive(work_.team());  // points without pressure would take most of the memory
  } catch (const std::bad_alloc&) {
    kept = {};  // the answer is written: all of them are kept
  }
  if (kept.empty()) kept = std::move(finished.pressures);
  memory_.record({std::move(kept), result.approach, result.load, true, std::move(finished.kept)});
  if (leaves_indentation_) overlap_ = std::move(finished.overlap);
}

void GridContact::adopt(StepSurface&& given) {
  bool same = !work_.surface.empty() && given.equals(work_.surface, work_.team());
  if (work_.ranks()) same = !work_.ranks()->any(!same);
  memory_.surface_is(same);
  if (!same) {
    work_.facts.tilt.reset();
    ++surfaces_;
  }
  work_.surface = std::move(given);
  fill_masked();
}

void GridContact::reset() {
  forget_surface();
  work_.solver_grids.clear();
  work_.forget_operators();
}

void GridContact::forget_surface() {
  work_.surface.clear();
  work_.record.certified = 0;
  memory_ = {};
  indentation_ = {};
  overlap_ = {};
}

void GridContact::forget_operators() {
  work_.forget_operators();
  work_.solver_grids.forget();
}

void GridContact::forget() {
  forget_operators();
  forget_surface();
}

void GridContact::restore(Memory&& memory, StepSurface&& surface, Indentation&& indentation) {
  forget();
  adopt(std::move(surface));
  memory_ = std::move(memory);
  indentation_ = std::move(indentation);
}

}  // namespace rc
