#include "contact/grids/grid_contact.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <new>
#include <utility>
#include <vector>

#include "contact/operators.h"
#include "contact/step/solve.h"
#include "core/error.h"
#include "core/grid.h"

namespace rc {

namespace {

// A surface, and the indentation that is in its gap.
struct IndentedSurface {
  StepSurface surface;
  Indentation indentation;
};

double longer_side(const rc_system& system) {
  return std::max(system.hx * static_cast<double>(system.nx), system.hy * static_cast<double>(system.ny));
}

// creep: null, or the bodies' with a step.
StepSurface surface_with(const Indentation& indentation, std::span<const std::uint8_t> mask, const GridProblem& problem,
                         const std::pair<const Creep&, const CreepStep&>* creep = nullptr) {
  const rc_system& system = problem.system.given;
  std::vector<double> gap;
  problem.rows().on_all([&] {
    gap = indentation.indented();
    if (creep) creep->first.put_into(gap, creep->second, problem.team());
  });
  const int roundings = creep ? creep->first.roundings() : 1;
  return StepSurface({system.nx, problem.rows().own(system.ny), gap, mask, false, longer_side(system), roundings}, problem.team(),
                     problem.rows());
}

// The surface that this step describes; nothing if it keeps that of the step before.
std::optional<IndentedSurface> given_surface(const rc_step& step, const GridProblem& problem, const Indentation& indentation,
                                             const Creep& creep, const CreepStep& creep_step) {
  const auto n = static_cast<std::size_t>(problem.own_points());
  const bool given_anew = step.undeformed_gap.data != nullptr;
  const GapValues gap = given_anew ? GapValues(step.undeformed_gap, n) : problem.surface.gap();
  if (!given_anew && problem.surface.empty())
    fail(RC_ERR_ARGUMENT, "rc_step.undeformed_gap.data is null and no earlier step gave one");
  if (!given_anew && !step.mask.data && creep.none()) return std::nullopt;
  const std::span<const std::uint8_t> mask(values_of<std::uint8_t>(step.mask), step.mask.data ? n : 0);
  if (!creep.none()) {  // of a copy of the gap, which each step puts what is left into
    IndentedSurface given;
    problem.rows().on_all([&] { given.indentation = given_anew ? indentation.of(gap) : indentation; });
    const std::pair<const Creep&, const CreepStep&> bodies(creep, creep_step);
    given.surface =
        surface_with(given.indentation, given_anew || step.mask.data ? mask : problem.surface.mask(), problem, &bodies);
    return given;
  }
  if (!indentation.none()) {
    IndentedSurface given{{}, given_anew ? indentation.of(gap) : indentation};
    given.surface = surface_with(given.indentation, mask, problem);
    return given;
  }
  const rc_system& system = problem.system.given;
  const bool borrowed = given_anew && step.borrow != 0;
  const GivenSurface given{system.nx, problem.rows().own(system.ny), gap, mask, borrowed, longer_side(system)};
  return IndentedSurface{StepSurface(given, problem.team(), problem.rows()), {}};
}

void check_pressures(const rc_step& step, const Outputs& outputs, const GridProblem& problem) {
  if (!outputs.p.wanted()) fail(RC_ERR_ARGUMENT, "rc_result.p.data is null: the pressures to certify are expected there");
  const StepSurface& last = problem.surface;
  problem.rows().on_all([&] {
    for (std::int64_t k = 0; k < problem.own_points(); ++k) {
      const auto i = static_cast<std::size_t>(k);
      const double p = outputs.p.at(i);
      const auto at = [&] { return place(problem.rows().first() * problem.system.given.nx + k, problem.system.given.nx); };
      if (!std::isfinite(p)) fail(RC_ERR_ARGUMENT, "rc_result.p[", i, "] = ", p, " is not finite (", at(), ")");
      if (p != 0 && (step.mask.data ? values_of<std::uint8_t>(step.mask)[i] == 0
                                    : !step.undeformed_gap.data && !last.empty() && !last.included(i)))
        fail(RC_ERR_ARGUMENT, "rc_result.p[", i, "] = ", p, " but this point is excluded by the mask (", at(), ")");
    }
  });
}

}  // namespace

Monitor GridContact::monitor() const {
  return {watcher_.cancelled, watcher_.progress, problem_.options.real(RC_OPT_TIME_LIMIT),
          problem_.options.integer(RC_OPT_MAX_ITER), problem_.operators().spent()};
}

// Puts what the last step has left into the surface, which counts as the same; with creep the next step does so.
void GridContact::settle() {
  problem_.rows().on_all([&] { creep_.settle(problem_.team()); });
  if (!problem_.rows().any(!overlap_.empty())) return;
  Indentation next;
  problem_.rows().on_all([&] { next = indentation_.with(overlap_, problem_.surface.gap()); });
  if (creep_.none()) problem_.surface = surface_with(next, problem_.surface.mask(), problem_);
  indentation_ = std::move(next);
  overlap_ = {};
}

void GridContact::write_indentation(std::span<double> to) const {
  indentation_.write(to);
  overlap_.add_to(to);
}

Step GridContact::prepare(const rc_step& given_step) {
  problem_.company().forget_stop();
  settle();
  CreepStep creep_step = creep_.step_to(given_step.time);
  Step step = step_of(given_step);
  if (!step.target.by_load()) step.target.value /= creep_step.compliance;
  std::optional<IndentedSurface> given = given_surface(given_step, problem_, indentation_, creep_, creep_step);
  check(step, problem_, given ? given->surface : problem_.surface, creep_step.compliance);
  if (given) {
    adopt(std::move(given->surface));
    indentation_ = std::move(given->indentation);
  }
  memory_.indented = !indentation_.none();
  if (!creep_.none()) {
    problem_.compliance = creep_step.compliance;
    memory_.last.approach = memory_.last.reported / problem_.compliance;
    creep_.begin(std::move(creep_step));
  }
  start_solve();
  return step;
}

void GridContact::start_solve() {
  if (problem_.options.integer(RC_OPT_RESUMABLE) != 0) forget_operators();
  grids_.start_solve();
  memory_.outcome = {};
}

Numbers GridContact::solve_prepared(const Step& step, Monitor& monitor, const Outputs& outputs,
                                    const std::optional<Estimate>& nearer) {
  const Rest after(problem_);
  auto [result, outcome] = solve_step(problem_, memory_, step, monitor, outputs, nearer);
  memory_.outcome = std::move(outcome);
  Numbers numbers = result.numbers;
  if (numbers.status == RC_OK) {
    remember(std::move(result), Choice(memory_.outcome.choice));
    memory_.outcome.certified = step.target.control;
    memory_.outcome.undecided = numbers.bounds.undecided;
  }
  numbers.work.levels = grids_.current();
  numbers.multiply_lengths(problem_.compliance);
  return numbers;
}

Numbers GridContact::certify(const rc_step& step, const Outputs& outputs, std::optional<double> compression) {
  if (!compression) check_pressures(step, outputs, problem_);
  const Step prepared = prepare(step);
  const Rest after(problem_);
  const std::atomic<bool> never{false};  // a cancellation is meant for a step
  Monitor once(never, {}, 0, 1, problem_.operators().spent());
  StepResult result = certify_given(problem_, prepared.target, Attempt{once}, outputs, compression);
  Numbers numbers = result.numbers;
  if (compression) keep_bodies(std::move(result));
  numbers.multiply_lengths(problem_.compliance);
  return numbers;
}

void GridContact::keep_bodies(StepResult&& result) {
  if (!problem_.goal.changes_bodies) return;
  overlap_ = std::move(result.overlap);
  if (!creep_.none()) creep_.leave(std::move(result.deflection));
}

void GridContact::remember(StepResult&& result, const Choice& by) {
  memory_.outcome.choice = by;
  Pressures kept;
  try {
    kept = result.pressures.positive(problem_.team());  // points without pressure would take most of the memory
  } catch (const std::bad_alloc&) {
    kept = {};  // the answer is written: all of them are kept
  }
  if (kept.empty()) kept = std::move(result.pressures);
  const Numbers& numbers = result.numbers;
  memory_.record({std::move(kept), numbers.approach, numbers.load(problem_.system), true, std::move(result.kept),
                  numbers.approach * problem_.compliance});
  keep_bodies(std::move(result));
}

void GridContact::adopt(StepSurface&& given) {
  const bool same = creep_.none() && !problem_.rows().any(problem_.surface.empty() || !same_surface(given, problem_.surface));
  memory_.surface_is(same);
  if (!same) problem_.facts.tilt.reset();
  problem_.surface = std::move(given);
}

// Includes the operators of coarser grids.
void GridContact::forget_operators() {
  problem_.operators().forget();
  grids_.forget();
}

void GridContact::forget(Forgotten what) {
  forget_operators();
  memory_.forget();
  if (what == Forgotten::steps) return;
  problem_.surface = {};
  problem_.compliance = 1;
  indentation_ = {};
  overlap_ = {};
  creep_.forget();
  if (what == Forgotten::grids) grids_.clear();
}

void GridContact::restore(Memory&& memory, StepSurface&& surface, Indentation&& indentation, Creep&& creep) {
  forget(Forgotten::surface);
  adopt(std::move(surface));
  memory_.last = std::move(memory.last);
  memory_.before = std::move(memory.before);
  indentation_ = std::move(indentation);
  creep_ = std::move(creep);
}

}  // namespace rc
