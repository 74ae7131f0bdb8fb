// Contact at few of the points. A coarser grid estimates where, and the tiles there become the unknowns. The operator screens all
// other points for overlap, without a product over the whole grid. Tiles that overlap are added and the step is solved again, so
// the answer is that of all points. Where the operator cannot screen, as with periodic boundaries, single points become the
// unknowns, and a product over the whole grid shows all others; ranks make it together, each looks at its rows.
#include "contact/sparse/sparse_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/grid_contact.h"
#include "contact/grids/pyramid.h"
#include "contact/sparse/screening.h"
#include "contact/step/approach.h"
#include "contact/step/by_load.h"
#include "contact/step/services.h"
#include "contact/step/target.h"
#include "contact/step/trial_set.h"
#include "core/error.h"

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
constexpr std::int64_t most_compact = 1 << 20;  // points of such a box that every rank solves alike

std::int64_t count_positive(const std::vector<double>& values) {
  return std::count_if(values.begin(), values.end(), [](double value) { return value > 0; });
}

// Where the unknowns are: in tiles or at points, whose numbers are ascending.
class Region {
 public:
  Region(const Workspace& work, bool of_tiles) : work_(work), of_tiles_(of_tiles) {}

  // Returns whether any of the points is new to it.
  bool add(const std::vector<std::int64_t>& points) {
    const std::size_t before = members_.size();
    for (const std::int64_t point : points) {
      const std::int64_t member = of_tiles_ ? tile_of(point) : point;
      if (members_.empty() || members_.back() != member) members_.push_back(member);
    }
    std::sort(members_.begin(), members_.end());
    members_.erase(std::unique(members_.begin(), members_.end()), members_.end());
    return members_.size() > before;
  }

  // Of its tiles, the points with a gap below the limit.
  TrialSet below(double limit) const {
    if (of_tiles_) return work_.surface.below(limit, members_);
    return {static_cast<std::int64_t>(members_.size()), members_};
  }
  bool of_tiles() const { return of_tiles_; }

 private:
  std::int64_t tile_of(std::int64_t point) const {
    const std::int64_t nx = work_.system.given.nx;
    return point / nx / StepSurface::tile * work_.surface.tiles_x() + point % nx / StepSurface::tile;
  }

  const Workspace& work_;
  const bool of_tiles_;
  std::vector<std::int64_t> members_;
};

// Every point that the approach can reach, where these lie in a small part of the grid; else nothing.
TrialSet reachable(const Workspace& work, const Estimate& estimate, double limit) {
  if (!work.system.positive) return {};
  const std::int64_t box = work.surface.extent_below(limit).box();
  if (work.surface.tiles() && box > most_compact) return {};
  return estimate.pressures.empty() || compact * box > work.system.points() ? TrialSet{} : work.surface.below(limit);
}

// Points that carry pressure, or have a small gap, under an estimate.
std::vector<std::int64_t> points_under(Workspace& work, const Estimate& estimate, const Choice& choice) {
  Answer guess;
  guess.choice = choice;
  guess.length_unit = estimate.approach - work.surface.lowest();
  guess.pressure_unit = guess.length_unit / work.system.length_per_pressure;
  guess.op = &work.bound_operator(*choice.backend, estimate.pressures.on);
  guess.p = estimate.pressures.p;
  for (double& value : guess.p) value /= guess.pressure_unit;
  const double compression = guess.length_unit, margin = halo * compression;
  const Deflected found = screened(work, guess, compression, margin);
  std::vector<std::int64_t> points;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const std::size_t i = found.point(k);
    if (found.p()[k] > 0 || (work.surface.included(i) && found.product[k] - (compression - work.surface.height(i)) < margin))
      points.push_back(static_cast<std::int64_t>(i));
  }
  return points;
}

// Points without pressure that overlap by more than the certificate allows.
std::vector<std::int64_t> overlapping(const Workspace& work, const Deflected& found, double compression, double scale) {
  const double allowed = 0.9 * work.options.real(RC_OPT_TOL) * scale;
  std::vector<std::int64_t> points;
  for (std::size_t k = 0; k < found.size(); ++k)
    if (!(found.p()[k] > 0) && work.surface.included(found.point(k)) &&
        found.product[k] - (compression - work.surface.height(found.point(k))) < -allowed)
      points.push_back(static_cast<std::int64_t>(found.point(k)));
  return points;
}

std::optional<Answer> solve_few(Workspace& work, const Memory& memory, const rc_step& step, const Choice& choice,
                                Estimate estimate, Monitor& monitor) {
  const StepSurface& surface = work.surface;
  const System& system = work.system;
  const bool by_load = step.control == RC_CONTROL_LOAD;
  const double lowest = surface.lowest(), load = step.target / system.cell_area();
  Region region(work, screens(choice));
  for (int round = 0;; ++round) {
    const double depth = estimate.approach - lowest;
    if (!(depth > 0) || estimate.pressures.empty()) return std::nullopt;
    const double limit = by_load ? estimate.approach + headroom * depth : step.target;
    TrialSet trial = reachable(work, estimate, limit);
    const bool whole = trial.n > 0;
    if (!whole && round == 0) region.add(points_under(work, estimate, choice));
    if (!whole) trial = region.below(limit);
    if (trial.n == 0) return std::nullopt;
    Answer answer;
    if (whole) {
      answer.choice = choose_for(trial, step.control, work);
      if (by_load && !(answer.choice.solver->controls & RC_CONTROL_LOAD)) return std::nullopt;
      answer.limit = limit - lowest;
      trial = widened(std::move(trial), answer.choice, work);
    } else {
      answer.choice = work.record.choice = choice;
    }
    answer.length_unit = depth;
    answer.pressure_unit = depth / system.length_per_pressure;
    answer.hardness = system.hardness;
    answer.op = &work.bound_operator(*answer.choice.backend, trial);
    answer.p = memory.start(step, trial, answer.pressure_unit, answer.cap(), &estimate.pressures, work.team());
    if (surface.tiles() && count_positive(answer.p) == 0) return std::nullopt;  // a cold start would read the whole gap
    const double datum = by_load ? lowest : step.target;
    const std::vector<double> u = compenetrations(answer, datum, work);
    double d = by_load ? 1 : 0;
    const double wanted = by_load ? load / answer.pressure_unit : 0;
    if (!(static_cast<double>(trial.n) * answer.cap() > wanted)) return std::nullopt;
    const double tol = solver_tol(work) * (by_load ? 1 : residual_scale(step, work, depth) / depth);
    answer.status = SolverRun(work, answer, monitor)(step.control, u, wanted, tol, datum, answer.p, d);
    answer.compression = by_load ? d * depth : compression_of(step, work);
    if (!std::isfinite(answer.compression)) return std::nullopt;

    estimate = {answer.pressures(), by_load ? lowest + answer.compression : step.target};
    const bool last = answer.status != RC_OK || round == most_tile_rounds;
    if (whole) {
      if (last || answer.compression <= limit - lowest) return answer;
      continue;
    }
    const double contacts = static_cast<double>(count_positive(answer.p));
    const double margin = std::min(halo, 30 * work.options.real(RC_OPT_TOL) * std::sqrt(contacts)) * depth;
    Deflected all = screened(work, answer, answer.compression, margin);
    const double scale = by_load ? answer.compression : residual_scale(step, work, answer.compression);
    const std::vector<std::int64_t> more = overlapping(work, all, answer.compression, scale);
    // A larger approach reaches more points of the same tiles: they are unknowns of the next round.
    const bool wider = region.add(more) || (region.of_tiles() && answer.compression > limit - lowest);
    if (more.empty() || last || !wider) {
      answer.checked = std::move(all);
      return answer;
    }
  }
}

// The last step's pressures or, where there were two sparse ones, those of the line through both.
std::optional<Estimate> last_estimate(const Workspace& work, const Memory& memory, const rc_step& step) {
  const CertifiedStep &last = memory.last, &older = memory.before;
  if (!step.warm_start || last.pressures.empty() || !last.same_gap) return std::nullopt;
  const auto sparse = [&](const Pressures& pressures) {
    return !pressures.empty() && few(count_positive(pressures.p), work.system.points(), work.rows());
  };
  const bool by_load = step.control == RC_CONTROL_LOAD;
  const double before = by_load ? last.load : last.approach - work.surface.lowest();
  const double now = by_load ? step.target : step.target - work.surface.lowest();
  const double part = sparse(older.pressures) ? memory.ahead(step) : 0;
  if (!(std::abs(now - before) <= (part != 0 ? near_line : near_target) * before) || !sparse(last.pressures)) return std::nullopt;
  Pressures found = last.pressures.positive(work.team());
  if (part != 0) {
    found.p = memory.start(step, found.on, 1, std::numeric_limits<double>::infinity(), nullptr, work.team());
    found = found.positive(work.team());
    if (found.empty()) return std::nullopt;
  }
  return Estimate{std::move(found), by_load ? last.approach + part * (last.approach - older.approach) : step.target};
}

// Whether a step takes contact that is not sparse farther.
bool grows_dense(const Workspace& work, const CertifiedStep& last, const rc_step& step) {
  if (!step.warm_start || last.pressures.empty() || !last.same_gap) return false;
  return step.target >= (step.control == RC_CONTROL_LOAD ? last.load : last.approach) &&
         !few(count_positive(last.pressures.p), work.system.points(), work.rows());
}

// How often a grid is halved for its estimate: once, but the largest grids until little memory is needed.
int halvings_of(std::int64_t points) {
  int halvings = 1;
  while (points >> (2 * halvings) > most_coarse_points) ++halvings;
  return halvings;
}

// All points of the blocks that carry pressure.
std::vector<std::int64_t> points_of(const Pressures& coarse, const Blocks& blocks) {
  std::vector<std::int64_t> points;
  for (std::size_t k = 0; k < coarse.p.size(); ++k) {
    if (!(coarse.p[k] > 0)) continue;
    const std::int64_t block = coarse.on.point(static_cast<std::int64_t>(k));
    const std::int64_t x = block % blocks.coarse_nx() * blocks.factor, y = block / blocks.coarse_nx() * blocks.factor;
    for (std::int64_t iy = y; iy < std::min(y + blocks.factor, blocks.ny); ++iy)
      for (std::int64_t ix = x; ix < std::min(x + blocks.factor, blocks.nx); ++ix) points.push_back(iy * blocks.nx + ix);
  }
  return points;
}

// The estimate from a coarser grid, which has its own from a still coarser one. dense: wanted even where contact is not sparse.
std::optional<Estimate> coarse_estimate(const Workspace& work, const rc_step& step, const Monitor& monitor, bool dense) {
  const rc_system& system = work.system.given;
  if (std::min(system.nx, system.ny) < 2 * least_sparse_side) return std::nullopt;
  rc_options options = coarse_options(work.options, monitor);
  options.set(RC_OPT_TOL, std::max(estimate_tol, work.options.real(RC_OPT_TOL)));
  const int halvings = work.surface.tiles() ? 1 : halvings_of(work.system.points());
  const HalvedGrid grid(work, options, halvings);
  Workspace& half = grid.contact().work();
  rc_step at = RC_STEP_INIT;
  at.control = step.control;
  at.target = step.target;
  if (nothing_touches(at, half)) return std::nullopt;

  Monitor watch = monitor.silent();
  std::optional<Estimate> coarser = coarse_estimate(half, at, monitor, dense);
  const std::optional<Choice> choice = choose_for_few(options, half.system, at.control, half.rows());
  std::optional<Answer> answer;
  if (choice && coarser && !coarser->dense) answer = solve_few(half, {}, at, *choice, *coarser, watch);
  if (!answer) {
    if ((choice || half.surface.tiles()) && (halvings > 1 || !dense)) return std::nullopt;
    answer = at.control == RC_CONTROL_LOAD ? at_load(half, {}, at, watch, std::move(coarser))
                                           : at_approach(half, {}, at, watch, std::move(coarser));
  }
  const std::int64_t contacts = count_positive(answer->p);
  if (contacts == 0) return std::nullopt;
  const Blocks blocks{system.nx, system.ny, std::int64_t{1} << halvings};
  if (GatheredTiles* const tiles = work.surface.tiles()) tiles->hold_tiles_of(points_of(answer->pressures(), blocks));
  return Estimate{spread(answer->pressures(), blocks, work.surface, Cut::same_pressure),
                  half.surface.lowest() + answer->compression, !few(contacts, half.system.points(), work.rows())};
}

}  // namespace

std::optional<Answer> sparse_contact(Workspace& work, const Memory& memory, const rc_step& step, Monitor& monitor,
                                     std::optional<Estimate>& estimate) {
  if (work.ranks() || step.p0 || !work.record.failed.empty()) return std::nullopt;
  const std::optional<Choice> choice = choose_for_few(work.options, work.system, step.control, work.rows());
  if (!choice || !(choice->solver->controls & static_cast<std::uint32_t>(step.control))) return std::nullopt;
  if (estimate && !few(count_positive(estimate->pressures.p), work.system.points(), work.rows())) return std::nullopt;
  std::optional<Estimate> start = estimate ? estimate : last_estimate(work, memory, step);
  if (!start) {
    if (grows_dense(work, memory.last, step)) return std::nullopt;
    // Ranks that do not find sparse contact start on coarser grids in another way.
    const bool cold = !work.alike() && (!step.warm_start || memory.last.pressures.empty());
    start = coarse_estimate(work, step, monitor, cold);
    if (!start) return std::nullopt;
    if (start->dense) {
      if (cold) estimate = std::move(start);
      return std::nullopt;
    }
  }
  return solve_few(work, memory, step, *choice, std::move(*start), monitor);
}

}  // namespace rc
