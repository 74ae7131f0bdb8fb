#include "contact/step/sparse_contact.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/operators.h"
#include "contact/sparse/screening.h"
#include "contact/step/trial.h"
#include "contact/step/whole_contact.h"
#include "contact/surface/points_below.h"

namespace rc {

namespace {

constexpr double near_target = 0.02;  // largest relative change of the target at which the last step serves as estimate
constexpr double near_line = 0.3;     // the same for the line through the last two steps
constexpr double far_load = 1.25;     // ratio of two loads beyond which coarser grids give a better start than the last step
constexpr double halo = 0.02;     // of the compression: tiles, or points, with a smaller gap under the estimate become unknowns
constexpr double headroom = 0.1;  // of the compression: room for an approach above its estimate, in load control
constexpr int most_tile_rounds = 8;             // of adding tiles
constexpr std::int64_t compact = 16;            // boxes of at most 1/compact of the grid's points are solved whole, by transforms
constexpr std::int64_t most_compact = 1 << 20;  // points of such a box that every process solves

bool at_few(const Pressures& contact, const GridProblem& problem) {
  return are_few(contact.contacts(), problem.system.points(), problem.operators().multiply_by_rows());
}

// Every point that the approach can reach, if these lie in a small part of the grid; else nothing.
TrialSet reachable(const GridProblem& problem, double limit) {
  if (!problem.system.positive) return {};
  const std::int64_t most = problem.system.points() / compact;
  return points_below(limit, problem.surface, problem.surface.gathered() ? std::min(most, most_compact) : most);
}

// Unknowns: points by themselves, or those of tiles. Their numbers are ascending.
class Region {
 public:
  Region(const StepSurface& surface, bool of_tiles) : surface_(surface), of_tiles_(of_tiles) {}

  // Returns whether any of the points is new to it.
  bool add(const std::vector<std::int64_t>& points) {
    const std::size_t before = members_.size();
    for (const std::int64_t point : points) {
      const std::int64_t member = of_tiles_ ? surface_.tiles().of(point) : point;
      if (members_.empty() || members_.back() != member) members_.push_back(member);
    }
    std::sort(members_.begin(), members_.end());
    members_.erase(std::unique(members_.begin(), members_.end()), members_.end());
    return members_.size() > before;
  }
  // The members, or by tiles the points with a gap below the limit.
  TrialSet below(double limit) const {
    if (!of_tiles_) return {static_cast<std::int64_t>(members_.size()), members_};
    TrialSet trial;
    surface_.hold(members_);
    for (const std::int64_t tile : members_)
      surface_.each_below_in(tile, limit, [&](std::int64_t point) { trial.index.push_back(point); });
    std::sort(trial.index.begin(), trial.index.end());
    trial.n = static_cast<std::int64_t>(trial.index.size());
    if (trial.n == surface_.points().count()) trial.index.clear();
    return trial;
  }
  bool of_tiles() const { return of_tiles_; }

 private:
  const StepSurface& surface_;
  const bool of_tiles_;
  std::vector<std::int64_t> members_;
};

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

// Points without pressure that overlap by more than the certificate allows. scale: that of its residuals.
std::vector<std::int64_t> overlapping(const GridProblem& problem, const Deflected& found, double compression, double scale) {
  const double allowed = 0.9 * problem.options.real(RC_OPT_TOL) * scale;
  std::vector<std::int64_t> points;
  for (std::size_t k = 0; k < found.size(); ++k)
    if (!(found.p()[k] > 0) && problem.surface.included(found.point(k)) &&
        found.product[k] - (compression - problem.surface.height(found.point(k))) < -allowed)
      points.push_back(static_cast<std::int64_t>(found.point(k)));
  return points;
}

// choice: for sparse contact on this grid. Nothing if the estimate has no contact, or one that cannot carry the load.
std::optional<Answer> solve_near(Estimate estimate, const GridProblem& problem, const Target& target, const Choice& choice,
                                 const Attempt& attempt) {
  const StepSurface& surface = problem.surface;
  const bool by_load = target.by_load();
  const double lowest = surface.lowest();
  Region region(surface, screens(choice));
  for (int round = 0;; ++round) {
    const double compression = estimate.approach - lowest;
    if (!(compression > 0) || estimate.pressures.empty()) return std::nullopt;
    const double limit = by_load ? estimate.approach + headroom * compression : target.value;
    TrialSet set = reachable(problem, limit);
    const bool whole = set.n > 0;
    if (!whole && round == 0) region.add(points_under(problem, estimate, choice));
    if (!whole) set = region.below(limit);
    if (set.n == 0) return std::nullopt;
    Trial trial(problem, target, std::move(set), compression, attempt, whole ? std::nullopt : std::optional<Choice>(choice));
    Answer& answer = trial.answer;
    if (whole && by_load && !(answer.choice.solver->controls & RC_CONTROL_LOAD)) return std::nullopt;
    if (whole) answer.limit = limit - lowest;
    trial.bind();
    trial.start(estimate.pressures);
    if (surface.gathered() && std::ranges::none_of(answer.p, [](double p) { return p > 0; }))
      return std::nullopt;  // a cold start would read the whole gap
    if (!(static_cast<double>(trial.set().n) * answer.units.cap() > trial.load())) return std::nullopt;
    trial.solve(1);
    if (!std::isfinite(answer.compression)) return std::nullopt;

    estimate = {answer.pressures(), by_load ? lowest + answer.compression : target.value};
    const bool last = answer.status != RC_OK || round == most_tile_rounds;
    const bool within = answer.compression <= limit - lowest;
    if (whole) {
      if (last || within) return std::move(answer);
      continue;
    }
    const double contacts = static_cast<double>(estimate.pressures.contacts());
    const double margin = std::min(halo, 30 * problem.options.real(RC_OPT_TOL) * std::sqrt(contacts)) * compression;
    Deflected all = screened(problem, answer, answer.compression, margin);
    const std::vector<std::int64_t> more = overlapping(problem, all, answer.compression, trial.scale(answer.compression));
    // A larger approach reaches more points of the same tiles: they are unknowns of the next round.
    const bool wider = region.add(more) || (region.of_tiles() && !within);
    if (more.empty() || last || !wider) {
      answer.checked = std::move(all);
      return std::move(answer);
    }
  }
}

// The last step's pressures or, if both last steps were sparse, those of the line through them.
std::optional<Estimate> last_estimate(const GridProblem& problem, const Target& target, const Start& start) {
  const CertifiedStep &last = start.last(), &older = start.before();
  if (last.pressures.empty() || !last.same_gap) return std::nullopt;
  const bool by_load = target.by_load();
  const double lowest = problem.surface.lowest();
  const double before = by_load ? last.load : last.approach - lowest, now = by_load ? target.value : target.value - lowest;
  const double ahead = at_few(older.pressures, problem) ? start.ahead() : 0;
  if (!(std::abs(now - before) <= (ahead != 0 ? near_line : near_target) * before) || !at_few(last.pressures, problem))
    return std::nullopt;
  Pressures found = last.pressures.positive(problem.team());
  if (ahead != 0) {
    found.p = start.extrapolated(found.on);
    found = found.positive(problem.team());
    if (found.empty()) return std::nullopt;
  }
  return Estimate{std::move(found), by_load ? last.approach + ahead * (last.approach - older.approach) : target.value};
}

// Whether a step takes contact that is not sparse farther.
bool grows_dense(const GridProblem& problem, const Target& target, const CertifiedStep& last) {
  if (last.pressures.empty() || !last.same_gap) return false;
  return target.value >= (target.by_load() ? last.load : last.approach) && !at_few(last.pressures, problem);
}

// Whether neither the last steps nor the caller give a start near the target. Processes that do not find sparse contact by rows
// start on coarser grids in another way.
bool starts_far(const GridProblem& problem, const Target& target, const Start& start) {
  if (!problem.company().stops_between_products()) return false;
  if (start.last().pressures.empty()) return true;
  if (!target.by_load() || start.ahead() != 0) return false;
  const double ratio = target.value / start.last().load;
  return ratio > far_load || ratio < 1 / far_load;
}

enum class Levels {
  while_few,  // only if contact is at few points of every level that is large enough for it
  whole       // in any case
};

// The estimate from coarser grids: solves the levels of the pyramid that are left, each from the one before.
std::optional<Estimate> coarse_estimate(Pyramid& pyramid, Levels levels, const Attempt& attempt) {
  const Target& target = pyramid.target();
  while (const Level* const level = pyramid.next()) {
    const GridProblem& grid = level->problem();
    Monitor watch = attempt.monitor.silent();
    const Attempt here{.monitor = watch, .failed = attempt.failed};
    std::optional<Estimate> estimate = pyramid.estimate();
    const std::optional<Choice> choice = attempt.failed.empty() ? choose_for_few(grid, target.control) : std::nullopt;
    std::optional<Answer> answer;
    if (choice && estimate && !estimate->dense) answer = solve_near(*estimate, grid, target, *choice, here);
    const bool may_be_few = choice || grid.surface.gathered();
    if (!answer && may_be_few && (levels == Levels::while_few || level->halvings() > 1)) {
      pyramid.give_up();
      return std::nullopt;
    }
    if (!answer) answer = whole_contact(grid, target, {}, here, std::move(estimate));
    pyramid.solved(std::move(*answer));
  }
  return pyramid.estimate();
}

}  // namespace

SparseContact sparse_contact(const GridProblem& problem, const Target& target, const Start& start, const Choice& few,
                             Pyramid& pyramid, const Attempt& attempt) {
  const bool passed_over = !attempt.failed.empty();  // the choice may be what failed
  std::optional<Estimate> estimate;
  if (!passed_over) estimate = last_estimate(problem, target, start);
  if (!estimate) {
    const bool far = starts_far(problem, target, start);
    if (grows_dense(problem, target, start.last()) || (passed_over && !far)) {
      pyramid.give_up();
      return {};
    }
    estimate = coarse_estimate(pyramid, far ? Levels::whole : Levels::while_few, attempt);
    if (!estimate) return {};
    if (estimate->dense || passed_over) return {{}, far ? std::move(estimate) : std::nullopt};
  }
  return {solve_near(std::move(*estimate), problem, target, few, attempt), {}};
}

std::optional<Answer> sparse_contact_near(const Estimate& estimate, const GridProblem& problem, const Target& target,
                                          const Choice& few, const Attempt& attempt) {
  if (!attempt.failed.empty() || !at_few(estimate.pressures, problem)) return std::nullopt;
  return solve_near(estimate, problem, target, few, attempt);
}

}  // namespace rc
