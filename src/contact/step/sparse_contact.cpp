// Contact at few of the points: the last steps, or else a coarser grid, estimate where it is, and these points are solved.
#include "contact/step/sparse_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/operators.h"
#include "contact/step/by_approach.h"
#include "contact/step/by_load.h"
#include "contact/step/few.h"

namespace rc {

namespace {

constexpr double near_target = 0.02;  // largest relative change of the target at which the last step serves as estimate
constexpr double near_line = 0.3;     // the same for the line through the last two steps
constexpr double far_load = 1.25;     // ratio of two loads beyond which coarser grids give a better start than the last step

// The last step's pressures or, where there were two sparse ones, those of the line through both.
std::optional<Estimate> last_estimate(const GridProblem& problem, const Memory& memory, const Step& step) {
  const CertifiedStep &last = memory.last, &older = memory.before;
  if (!step.warm || last.pressures.empty() || !last.same_gap) return std::nullopt;
  const bool by_load = step.target.by_load();
  const double before = by_load ? last.load : last.approach - problem.surface.lowest();
  const double now = by_load ? step.target.value : step.target.value - problem.surface.lowest();
  const double part = at_few(older.pressures, problem) ? memory.ahead(step) : 0;
  if (!(std::abs(now - before) <= (part != 0 ? near_line : near_target) * before) || !at_few(last.pressures, problem))
    return std::nullopt;
  Pressures found = last.pressures.positive(problem.team());
  if (part != 0) {
    found.p = memory.start(step, found.on, 1, std::numeric_limits<double>::infinity(), nullptr, problem.team());
    found = found.positive(problem.team());
    if (found.empty()) return std::nullopt;
  }
  return Estimate{std::move(found), by_load ? last.approach + part * (last.approach - older.approach) : step.target.value};
}

// Whether a step takes contact that is not sparse farther.
bool grows_dense(const GridProblem& problem, const CertifiedStep& last, const Step& step) {
  if (!step.warm || last.pressures.empty() || !last.same_gap) return false;
  return step.target.value >= (step.target.by_load() ? last.load : last.approach) && !at_few(last.pressures, problem);
}

// Whether neither the last steps nor the caller give a start near the target. Processes that do not find sparse contact by rows
// start on coarser grids in another way.
bool starts_far(const GridProblem& problem, const Memory& memory, const Step& step) {
  if (!problem.company().stops_between_products()) return false;
  if (!step.warm || memory.last.pressures.empty()) return true;
  if (!step.target.by_load() || memory.ahead(step) != 0) return false;
  const double ratio = step.target.value / memory.last.load;
  return ratio > far_load || ratio < 1 / far_load;
}

enum class Levels {
  while_few,  // only if contact is at few points of every level that is large enough for it
  whole       // in any case
};

// The estimate from coarser grids: solves the levels of the pyramid that are left, each from the one before.
std::optional<Estimate> coarse_estimate(Pyramid& pyramid, const Target& target, Levels levels, const Attempt& attempt) {
  pyramid.build(target, attempt.monitor);
  const Step step{target};
  while (const Level* const level = pyramid.next()) {
    const GridProblem& grid = level->problem();
    Monitor watch = attempt.monitor.silent();
    const Attempt here{.monitor = watch, .failed = attempt.failed};
    std::optional<Estimate> estimate = pyramid.estimate();
    const std::optional<Choice> choice = attempt.failed.empty() ? choose_few(grid, step) : std::nullopt;
    std::optional<Answer> answer;
    if (choice && estimate && !estimate->dense) answer = solve_few(grid, {}, step, *choice, *estimate, here);
    const bool may_be_few = choice || grid.surface.gathered();
    if (!answer && may_be_few && (levels == Levels::while_few || level->halvings() > 1)) {
      pyramid.give_up();
      return std::nullopt;
    }
    if (!answer)
      answer =
          target.by_load() ? at_load(grid, {}, step, here, std::move(estimate)) : at_approach(grid, {}, step, here, estimate);
    pyramid.solved(std::move(*answer));
  }
  return pyramid.estimate();
}

}  // namespace

SparseContact sparse_contact(const GridProblem& problem, const Memory& memory, const Step& step, Pyramid& pyramid,
                             const Attempt& attempt) {
  const std::optional<Choice> choice = choose_few(problem, step);
  if (!choice) return {};
  const bool passed_over = !attempt.failed.empty();  // the choice may be what failed
  std::optional<Estimate> start;
  if (!passed_over) start = last_estimate(problem, memory, step);
  if (!start) {
    const bool far = starts_far(problem, memory, step);
    if (grows_dense(problem, memory.last, step) || (passed_over && !far)) {
      pyramid.give_up();
      return {};
    }
    start = coarse_estimate(pyramid, step.target, far ? Levels::whole : Levels::while_few, attempt);
    if (!start) return {};
    if (start->dense || passed_over) return {{}, far ? std::move(start) : std::nullopt};
  }
  return {solve_few(problem, memory, step, *choice, std::move(*start), attempt), {}};
}

}  // namespace rc
