// Contact at few of the points. A coarser grid estimates where, and the tiles there become the unknowns. The operator screens all
// other points for overlap, without a product over the whole grid. Tiles that overlap are added and the step is solved again, so
// the answer is that of all points. Where the operator cannot screen, as with periodic boundaries, single points become the
// unknowns, and a product over the whole grid shows all others; processes make it together, and each checks its rows.
#include "contact/step/sparse_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/coarse/level.h"
#include "contact/operators.h"
#include "contact/sparse/region.h"
#include "contact/sparse/screening.h"
#include "contact/step/by_approach.h"
#include "contact/step/by_load.h"
#include "contact/step/trial.h"
#include "contact/surface/blocks.h"
#include "contact/surface/points_below.h"

namespace rc {

namespace {

constexpr double estimate_tol = 1e-2;  // of an estimate: spreading the pressures loses further digits
constexpr double halo = 0.02;          // of the depth: tiles, or points, with a smaller gap under the estimate become unknowns
constexpr double headroom = 0.1;       // of the depth: room for an approach above its estimate, in load control
constexpr int most_tile_rounds = 8;    // of adding tiles
constexpr double near_target = 0.02;   // largest relative change of the target at which the last step serves as estimate
constexpr double near_line = 0.3;      // the same for the line through the last two steps
constexpr std::int64_t least_sparse_side = 64;
constexpr std::int64_t most_coarse_points = 8192 * 8192;  // of the grid that gives the estimate
constexpr std::int64_t compact = 16;            // boxes of at most 1/compact of the grid's points are solved whole, by transforms
constexpr std::int64_t most_compact = 1 << 20;  // points of such a box that every process solves alike

std::int64_t count_positive(const std::vector<double>& values) {
  return std::count_if(values.begin(), values.end(), [](double value) { return value > 0; });
}

// Every point that the approach can reach, if these lie in a small part of the grid; else nothing.
TrialSet reachable(const GridProblem& problem, const Estimate& estimate, double limit) {
  if (!problem.system.positive) return {};
  const std::int64_t box = extent_below(limit, problem.surface).box();
  if (problem.surface.gathered() && box > most_compact) return {};
  return estimate.pressures.empty() || compact * box > problem.system.points() ? TrialSet{}
                                                                               : points_below(limit, problem.surface);
}

// Points that carry pressure, or have a small gap, under an estimate.
std::vector<std::int64_t> points_under(const GridProblem& problem, const Estimate& estimate, const Choice& choice) {
  Answer guess = answer_in(estimate.approach - problem.surface.lowest(), choice, problem.system);
  guess.op = &problem.operators().bound(*choice.backend, estimate.pressures.on);
  guess.p = estimate.pressures.p;
  for (double& value : guess.p) value /= guess.units.pressure;
  const double compression = guess.units.length, margin = halo * compression;
  const Deflected found = screened(problem, guess, compression, margin);
  std::vector<std::int64_t> points;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const std::size_t i = found.point(k);
    if (found.p()[k] > 0 ||
        (problem.surface.included(i) && found.product[k] - (compression - problem.surface.height(i)) < margin))
      points.push_back(static_cast<std::int64_t>(i));
  }
  return points;
}

// Points without pressure that overlap by more than the certificate allows.
std::vector<std::int64_t> overlapping(const GridProblem& problem, const Deflected& found, double compression, double scale) {
  const double allowed = 0.9 * problem.options.real(RC_OPT_TOL) * scale;
  std::vector<std::int64_t> points;
  for (std::size_t k = 0; k < found.size(); ++k)
    if (!(found.p()[k] > 0) && problem.surface.included(found.point(k)) &&
        found.product[k] - (compression - problem.surface.height(found.point(k))) < -allowed)
      points.push_back(static_cast<std::int64_t>(found.point(k)));
  return points;
}

std::optional<Answer> solve_few(const GridProblem& problem, const Memory& memory, const Step& step, const Choice& choice,
                                Estimate estimate, Attempt& attempt) {
  const StepSurface& surface = problem.surface;
  const System& system = problem.system;
  const Target& target = step.target;
  const bool by_load = target.by_load();
  const double lowest = surface.lowest(), load = target.value / system.cell_area();
  Region region(problem, screens(choice));
  for (int round = 0;; ++round) {
    const double depth = estimate.approach - lowest;
    if (!(depth > 0) || estimate.pressures.empty()) return std::nullopt;
    const double limit = by_load ? estimate.approach + headroom * depth : target.value;
    TrialSet set = reachable(problem, estimate, limit);
    const bool whole = set.n > 0;
    if (!whole && round == 0) region.add(points_under(problem, estimate, choice));
    if (!whole) set = region.below(limit);
    if (set.n == 0) return std::nullopt;
    Trial trial(problem, step, std::move(set), depth, attempt, whole ? std::nullopt : std::optional<Choice>(choice));
    Answer& answer = trial.answer;
    if (whole && by_load && !(answer.choice.solver->controls & RC_CONTROL_LOAD)) return std::nullopt;
    if (whole) answer.limit = limit - lowest;
    trial.bind();
    trial.start(memory, step, &estimate.pressures);
    if (surface.gathered() && count_positive(answer.p) == 0) return std::nullopt;  // a cold start would read the whole gap
    double d = by_load ? 1 : 0;
    const double wanted = by_load ? load / answer.units.pressure : 0;
    if (!(static_cast<double>(trial.set().n) * answer.units.cap() > wanted)) return std::nullopt;
    const double tol = solver_tol(problem) * (by_load ? 1 : residual_scale(target, problem, depth) / depth);
    trial.solve(wanted, tol, by_load ? lowest : target.value, d);
    answer.compression = by_load ? d * depth : target.compression(surface);
    if (!std::isfinite(answer.compression)) return std::nullopt;

    estimate = {answer.pressures(), by_load ? lowest + answer.compression : target.value};
    const bool last = answer.status != RC_OK || round == most_tile_rounds;
    if (whole) {
      if (last || answer.compression <= limit - lowest) return std::move(answer);
      continue;
    }
    const double contacts = static_cast<double>(count_positive(answer.p));
    const double margin = std::min(halo, 30 * problem.options.real(RC_OPT_TOL) * std::sqrt(contacts)) * depth;
    Deflected all = screened(problem, answer, answer.compression, margin);
    const double scale = by_load ? answer.compression : residual_scale(target, problem, answer.compression);
    const std::vector<std::int64_t> more = overlapping(problem, all, answer.compression, scale);
    // A larger approach reaches more points of the same tiles: they are unknowns of the next round.
    const bool wider = region.add(more) || (region.of_tiles() && answer.compression > limit - lowest);
    if (more.empty() || last || !wider) {
      answer.checked = std::move(all);
      return std::move(answer);
    }
  }
}

// The last step's pressures or, where there were two sparse ones, those of the line through both.
std::optional<Estimate> last_estimate(const GridProblem& problem, const Memory& memory, const Step& step) {
  const CertifiedStep &last = memory.last, &older = memory.before;
  if (!step.warm || last.pressures.empty() || !last.same_gap) return std::nullopt;
  const auto sparse = [&](const Pressures& pressures) {
    return !pressures.empty() &&
           few(count_positive(pressures.p), problem.system.points(), problem.operators().multiply_by_rows());
  };
  const bool by_load = step.target.by_load();
  const double before = by_load ? last.load : last.approach - problem.surface.lowest();
  const double now = by_load ? step.target.value : step.target.value - problem.surface.lowest();
  const double part = sparse(older.pressures) ? memory.ahead(step) : 0;
  if (!(std::abs(now - before) <= (part != 0 ? near_line : near_target) * before) || !sparse(last.pressures)) return std::nullopt;
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
  return step.target.value >= (step.target.by_load() ? last.load : last.approach) &&
         !few(count_positive(last.pressures.p), problem.system.points(), problem.operators().multiply_by_rows());
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
  const std::int64_t contacts = count_positive(answer->p);
  if (contacts == 0) return std::nullopt;
  const Blocks blocks{system.nx, system.ny, std::int64_t{1} << level.halvings()};
  if (GatheredTiles* const gathered = problem.surface.gathered())
    gathered->hold_tiles_of(blocks.points_under(answer->pressures()));
  return Estimate{spread(answer->pressures(), blocks, problem.surface, Cut::same_pressure),
                  half.surface.lowest() + answer->compression,
                  !few(contacts, half.system.points(), problem.operators().multiply_by_rows())};
}

}  // namespace

std::optional<Answer> sparse_contact(const GridProblem& problem, const Memory& memory, const Step& step, Attempt& attempt,
                                     std::optional<Estimate>& estimate) {
  const bool by_rows = problem.operators().multiply_by_rows();
  if (problem.company().keeps_all_points() || step.p0.data || !attempt.failed.empty()) return std::nullopt;
  const std::optional<Choice> choice = choose_for_few(problem.options, problem.system, step.target.control, by_rows);
  if (!choice || !(choice->solver->controls & static_cast<std::uint32_t>(step.target.control))) return std::nullopt;
  if (estimate && !few(count_positive(estimate->pressures.p), problem.system.points(), by_rows)) return std::nullopt;
  std::optional<Estimate> start = estimate ? estimate : last_estimate(problem, memory, step);
  if (!start) {
    if (grows_dense(problem, memory.last, step)) return std::nullopt;
    // Processes that do not find sparse contact by rows start on coarser grids in another way.
    const bool cold = problem.company().stops_between_products() && (!step.warm || memory.last.pressures.empty());
    start = coarse_estimate(problem, step.target, attempt.monitor, cold);
    if (!start) return std::nullopt;
    if (start->dense) {
      if (cold) estimate = std::move(start);
      return std::nullopt;
    }
  }
  return solve_few(problem, memory, step, *choice, std::move(*start), attempt);
}

}  // namespace rc
