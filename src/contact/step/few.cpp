// A coarser grid or the last steps estimate where contact is, and the tiles there become the unknowns. The operator screens all
// other points for overlap, without a product over the whole grid. Tiles that overlap are added and the step is solved again, so
// the answer is that of all points. Where the operator cannot screen, as with periodic boundaries, single points become the
// unknowns, and a product over the whole grid shows all others; processes make it together, and each checks its rows.
#include "contact/step/few.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/operators.h"
#include "contact/sparse/region.h"
#include "contact/sparse/screening.h"
#include "contact/step/trial.h"
#include "contact/surface/points_below.h"

namespace rc {

namespace {

constexpr double halo = 0.02;         // of the depth: tiles, or points, with a smaller gap under the estimate become unknowns
constexpr double headroom = 0.1;      // of the depth: room for an approach above its estimate, in load control
constexpr int most_tile_rounds = 8;   // of adding tiles
constexpr std::int64_t compact = 16;  // boxes of at most 1/compact of the grid's points are solved whole, by transforms
constexpr std::int64_t most_compact = 1 << 20;  // points of such a box that every process solves alike

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

}  // namespace

bool at_few(const Pressures& contact, const GridProblem& problem) {
  return few(contact.contacts(), problem.system.points(), problem.operators().multiply_by_rows());
}

std::optional<Choice> choose_few(const GridProblem& problem, const Step& step) {
  if (problem.rows().shared() || step.p0.data) return std::nullopt;
  const std::optional<Choice> choice =
      choose_for_few(problem.options, problem.system, step.target.control, problem.operators().multiply_by_rows());
  const bool controls = choice && (choice->solver->controls & static_cast<std::uint32_t>(step.target.control)) != 0;
  return controls ? choice : std::nullopt;
}

std::optional<Answer> solve_few(const GridProblem& problem, const Memory& memory, const Step& step, const Choice& choice,
                                Estimate estimate, const Attempt& attempt) {
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
    if (surface.gathered() && std::ranges::none_of(answer.p, [](double p) { return p > 0; }))
      return std::nullopt;  // a cold start would read the whole gap
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
    const double contacts = static_cast<double>(estimate.pressures.contacts());
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

std::optional<Answer> solve_if_few(const GridProblem& problem, const Memory& memory, const Step& step, const Estimate& nearer,
                                   const Attempt& attempt) {
  const std::optional<Choice> choice = choose_few(problem, step);
  if (!choice || !attempt.failed.empty() || !at_few(nearer.pressures, problem)) return std::nullopt;
  return solve_few(problem, memory, step, *choice, nearer, attempt);
}

}  // namespace rc
