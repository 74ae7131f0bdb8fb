#include "contact/grids/grid_contact.h"

#include <cmath>
#include <new>
#include <utility>
#include <vector>

#include "contact/operators.h"
#include "contact/step/solve.h"
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

StepSurface surface_with(const Indentation& indentation, std::span<const std::uint8_t> mask, const GridProblem& problem) {
  const rc_system& system = problem.system.given;
  const std::vector<double> gap = indentation.indented();
  return StepSurface({system.nx, problem.own_rows(), gap, mask, false}, problem.team(), problem.company());
}

// The surface that this step describes; nothing where it keeps that of the step before.
std::optional<IndentedSurface> given_surface(const rc_step& step, const GridProblem& problem, const Indentation& indentation) {
  const auto n = static_cast<std::size_t>(problem.own_points());
  const bool given_anew = step.undeformed_gap.data != nullptr;
  const GapValues gap = given_anew ? GapValues(step.undeformed_gap, n) : problem.surface.gap();
  if (!given_anew && problem.surface.empty())
    fail(RC_ERR_ARGUMENT, "rc_step.undeformed_gap.data is null and no earlier step gave one");
  if (!given_anew && !step.mask.data) return std::nullopt;
  const std::span<const std::uint8_t> mask(mask_of(step), step.mask.data ? n : 0);
  if (!indentation.none()) {
    IndentedSurface given{{}, given_anew ? indentation.of(gap) : indentation};
    given.surface = surface_with(given.indentation, mask, problem);
    return given;
  }
  const rc_system& system = problem.system.given;
  const GivenSurface given{system.nx, problem.own_rows(), gap, mask, given_anew && step.borrow != 0};
  return IndentedSurface{StepSurface(given, problem.team(), problem.company()), {}};
}

}  // namespace

void GridContact::watched_by(const Monitor& monitor, bool report) {
  progress_ = {report ? pass_on : ask, const_cast<Monitor*>(&monitor), 1};
}

Monitor GridContact::monitor() const {
  return {cancelled_, progress_, problem_.options.real(RC_OPT_TIME_LIMIT), problem_.options.integer(RC_OPT_MAX_ITER),
          problem_.operators().spent()};
}

// Puts what the last step has left into the surface, which counts as the same.
void GridContact::indent() {
  if (!problem_.company().any(!overlap_.empty())) return;
  Indentation next;
  problem_.company().on_all([&] { next = indentation_.with(overlap_, problem_.surface.gap()); });
  problem_.surface = surface_with(next, problem_.surface.masks(), problem_);
  fill_masked();
  indentation_ = std::move(next);
  overlap_ = {};
}

// Masked points stay unknowns if all points do.
void GridContact::fill_masked() {
  if (!problem_.company().keeps_all_points()) return;
  const rc_system& s = problem_.system.given;
  const double side = std::max(s.hx * static_cast<double>(s.nx), s.hy * static_cast<double>(s.ny));
  problem_.company().on_all([&] { problem_.surface.fill_masked(side); });
}

void GridContact::write_indentation(std::span<double> to) const {
  indentation_.write(to);
  overlap_.add_to(to);
}

Step GridContact::begin(const rc_step& given_step) {
  problem_.company().forget_stop();
  indent();
  const Step step = step_of(given_step);
  std::optional<IndentedSurface> given = given_surface(given_step, problem_, indentation_);
  check(step, problem_, given ? given->surface : problem_.surface);
  if (given) {
    adopt(std::move(given->surface));
    indentation_ = std::move(given->indentation);
  }
  memory_.indented = !indentation_.none();
  if (problem_.options.integer(RC_OPT_RESUMABLE) != 0) forget_operators();
  grids_.begin_step();
  outcome_ = {};
  return step;
}

Numbers GridContact::solve_begun(const Step& step, Monitor& monitor, const Outputs& outputs,
                                 const std::optional<Estimate>& nearer) {
  const Rest after(problem_);
  auto [finished, outcome] = solve_step(problem_, memory_, step, monitor, outputs, nearer);
  outcome_ = std::move(outcome);
  Numbers numbers = finished.numbers;
  if (numbers.status == RC_OK) {
    remember(std::move(finished), Choice(outcome_.choice));
    outcome_.certified = step.target.control;
    outcome_.undecided = numbers.bounds.undecided;
  }
  numbers.work.levels = grids_.current();
  return numbers;
}

Numbers GridContact::solve(const rc_step& step, const Outputs& outputs) {
  const Step begun = begin(step);
  Monitor watch = monitor();
  return solve_begun(begun, watch, outputs);
}

Numbers GridContact::certify(const rc_step& step, const Outputs& outputs) {
  if (!outputs.p.wanted()) fail(RC_ERR_ARGUMENT, "rc_result.p.data is null: the pressures to certify are expected there");
  const StepSurface& last = problem_.surface;
  problem_.company().on_all([&] {
    for (std::int64_t k = 0; k < problem_.own_points(); ++k) {
      const auto i = static_cast<std::size_t>(k);
      const double p = outputs.p.at(i);
      if (!std::isfinite(p)) fail(RC_ERR_ARGUMENT, "rc_result.p[", i, "] = ", p, " is not finite");
      if (p != 0 && (step.mask.data ? mask_of(step)[i] == 0 : !step.undeformed_gap.data && !last.empty() && !last.included(i)))
        fail(RC_ERR_ARGUMENT, "rc_result.p[", i, "] = ", p, " but this point is excluded by the mask");
    }
  });
  return certified(step, outputs, std::nullopt).numbers;
}

Numbers GridContact::retrace(const rc_step& step, double compression, const Outputs& outputs) {
  Finished finished = certified(step, outputs, compression);
  if (leaves_indentation_) overlap_ = std::move(finished.overlap);
  return std::move(finished.numbers);
}

Finished GridContact::certified(const rc_step& step, const Outputs& outputs, std::optional<double> compression) {
  const Step begun = begin(step);
  const Rest after(problem_);
  Monitor monitor(cancelled_, {}, 0, 1, problem_.operators().spent());
  Attempt attempt{monitor};
  return certify_given(problem_, begun, attempt, outputs, compression);
}

void GridContact::remember(Finished&& finished, const Choice& by) {
  outcome_.choice = by;
  Pressures kept;
  try {
    kept = finished.pressures.positive(problem_.team());  // points without pressure would take most of the memory
  } catch (const std::bad_alloc&) {
    kept = {};  // the answer is written: all of them are kept
  }
  if (kept.empty()) kept = std::move(finished.pressures);
  const Numbers& numbers = finished.numbers;
  memory_.record({std::move(kept), numbers.approach, numbers.load(problem_.system), true, std::move(finished.kept)});
  if (leaves_indentation_) overlap_ = std::move(finished.overlap);
}

void GridContact::adopt(StepSurface&& given) {
  const bool same = !problem_.company().any(problem_.surface.empty() || !given.equals(problem_.surface, problem_.team()));
  memory_.surface_is(same);
  if (!same) {
    problem_.facts.tilt.reset();
    ++surfaces_;
  }
  problem_.surface = std::move(given);
  fill_masked();
}

void GridContact::reset() {
  forget_surface();
  grids_.clear();
  problem_.operators().forget();
}

void GridContact::forget_surface() {
  problem_.surface.clear();
  outcome_.certified = 0;
  memory_ = {};
  indentation_ = {};
  overlap_ = {};
}

void GridContact::forget_operators() {
  problem_.operators().forget();
  grids_.forget();
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
