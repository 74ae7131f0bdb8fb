// Contact at few of the points: the last steps, or else a coarser grid, estimate where it is, and these points are solved.
#include "contact/step/sparse_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/coarse/level.h"
#include "contact/operators.h"
#include "contact/step/by_approach.h"
#include "contact/step/by_load.h"
#include "contact/step/few.h"
#include "contact/surface/blocks.h"

namespace rc {

namespace {

constexpr double estimate_tol = 1e-2;  // of an estimate: spreading the pressures loses further digits
constexpr double near_target = 0.02;   // largest relative change of the target at which the last step serves as estimate
constexpr double near_line = 0.3;      // the same for the line through the last two steps
constexpr std::int64_t least_sparse_side = 64;
constexpr std::int64_t most_coarse_points = 8192 * 8192;  // of the grid that gives the estimate

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

// How often a grid is halved for its estimate: once, but the largest grids until little memory is needed.
int halvings_of(std::int64_t points) {
  int halvings = 1;
  while (points >> (2 * halvings) > most_coarse_points) ++halvings;
  return halvings;
}

// The estimate from a coarser grid, which has its own from a still coarser one. dense: wanted even if contact is not sparse.
std::optional<Estimate> coarse_estimate(const GridProblem& problem, const Target& target, const Monitor& monitor, bool dense) {
  const rc_system& system = problem.system.given;
  if (std::min(system.nx, system.ny) < 2 * least_sparse_side) return std::nullopt;
  rc_options options = coarse_options(problem.options, monitor);
  options.set(RC_OPT_TOL, std::max(estimate_tol, problem.options.real(RC_OPT_TOL)));
  const Level level(problem, options, problem.surface.gathered() ? 1 : halvings_of(problem.system.points()));
  const GridProblem& half = level.problem();
  if (!target.touches(half.surface)) return std::nullopt;

  const Step at{target};
  Monitor watch = monitor.silent();
  Attempt attempt{watch};
  std::optional<Estimate> coarser = coarse_estimate(half, target, monitor, dense);
  const std::optional<Choice> choice = choose_for_few(options, half.system, target.control, half.operators().multiply_by_rows());
  std::optional<Answer> answer;
  if (choice && coarser && !coarser->dense) answer = solve_few(half, {}, at, *choice, *coarser, attempt);
  if (!answer) {
    if ((choice || half.surface.gathered()) && (level.halvings() > 1 || !dense)) return std::nullopt;
    answer = target.by_load() ? at_load(half, {}, at, attempt, std::move(coarser)) : at_approach(half, {}, at, attempt, coarser);
  }
  const Pressures found = answer->pressures();
  const std::int64_t contacts = found.contacts();
  if (contacts == 0) return std::nullopt;
  const Blocks blocks{system.nx, system.ny, std::int64_t{1} << level.halvings()};
  if (GatheredTiles* const gathered = problem.surface.gathered()) gathered->hold_tiles_of(blocks.points_under(found));
  return Estimate{spread(found, blocks, problem.surface, Cut::same_pressure), half.surface.lowest() + answer->compression,
                  !few(contacts, half.system.points(), problem.operators().multiply_by_rows())};
}

}  // namespace

SparseContact sparse_contact(const GridProblem& problem, const Memory& memory, const Step& step,
                             const std::optional<Estimate>& nearer, Attempt& attempt) {
  if (problem.company().keeps_all_points() || step.p0.data || !attempt.failed.empty()) return {};
  const std::optional<Choice> choice =
      choose_for_few(problem.options, problem.system, step.target.control, problem.operators().multiply_by_rows());
  if (!choice || !(choice->solver->controls & static_cast<std::uint32_t>(step.target.control))) return {};
  if (nearer && !at_few(nearer->pressures, problem)) return {};
  std::optional<Estimate> start = nearer ? nearer : last_estimate(problem, memory, step);
  if (!start) {
    if (grows_dense(problem, memory.last, step)) return {};
    // Processes that do not find sparse contact by rows start on coarser grids in another way.
    const bool cold = problem.company().stops_between_products() && (!step.warm || memory.last.pressures.empty());
    start = coarse_estimate(problem, step.target, attempt.monitor, cold);
    if (!start) return {};
    if (start->dense) return {{}, cold ? std::move(start) : std::nullopt};
  }
  return {solve_few(problem, memory, step, *choice, std::move(*start), attempt), {}};
}

}  // namespace rc
