// Contact at few of the points: a coarser grid tells where, whole tiles around become the unknowns, and the operator screens all
// other points, with no product over the grid. What overlaps is added and the step solved again, so the answer is that of all
// points.
#include <algorithm>
#include <cmath>

#include "contact/blocks.h"
#include "contact/contact.h"
#include "core/error.h"

namespace rc {

namespace {

constexpr double coarse_tol = 1e-2;  // of an estimate: more digits are lost when the pressures are spread
constexpr double halo = 0.02;        // of the depth: tiles that are no further apart under the estimate become unknowns
constexpr double headroom = 0.1;     // of the depth, by which the approach may exceed its estimate in load control
constexpr int most_rounds = 8;       // of adding tiles
constexpr double near = 0.02;        // relative change of the target for which the last step serves as an estimate
constexpr std::int64_t least_side = 64;
constexpr std::int64_t compact = 16;  // boxes of one part in so many of the grid are served best by transforms of the box

std::int64_t count_positive(const std::vector<double>& values) {
  return std::count_if(values.begin(), values.end(), [](double value) { return value > 0; });
}

}  // namespace

// Keeps `tiles` ascending.
void Contact::add_tiles(std::vector<std::int64_t>& tiles, const std::vector<std::int64_t>& points) const {
  const std::int64_t nx = system_.given.nx;
  for (const std::int64_t point : points) {
    const std::int64_t tile = point / nx / SurfaceState::tile * surface_.tiles_x() + point % nx / SurfaceState::tile;
    if (tiles.empty() || tiles.back() != tile) tiles.push_back(tile);
  }
  std::sort(tiles.begin(), tiles.end());
  tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
}

std::optional<Answer> Contact::at_few_points(const rc_step& step, Monitor& monitor, std::optional<Estimate> estimate) {
  if (step.p0) return std::nullopt;
  const std::optional<Choice> choice = choose_for_few(options_, system_, step.control, failed_);
  if (!choice) return std::nullopt;
  if (estimate && !few(count_positive(estimate->pressures.p), system_.points())) return std::nullopt;
  if (!estimate) estimate = last_estimate(step);
  if (!estimate) estimate = coarse_estimate(step, monitor);
  if (!estimate) return std::nullopt;
  return solve_few(step, *choice, std::move(*estimate), monitor);
}

std::optional<Estimate> Contact::last_estimate(const rc_step& step) const {
  if (!step.warm_start || last_.pressures.empty() || !last_.same_gap) return std::nullopt;
  const bool by_load = step.control == RC_CONTROL_LOAD;
  const double before = by_load ? last_.load : last_.approach - surface_.lowest();
  const double now = by_load ? step.target : step.target - surface_.lowest();
  if (!(std::abs(now - before) <= near * before)) return std::nullopt;
  Estimate estimate{last_.pressures.positive(), by_load ? last_.approach : step.target};
  if (!few(estimate.pressures.on.n, system_.points())) return std::nullopt;
  return estimate;
}

// From a grid of half as many points a side, which has its own from a coarser one where it is large itself.
std::optional<Estimate> Contact::coarse_estimate(const rc_step& step, const Monitor& monitor) {
  rc_system system = system_.given;
  if (std::min(system.nx, system.ny) < 2 * least_side) return std::nullopt;
  const CoarseGrid coarse = halved(surface_, system.nx, system.ny, *team_);
  system.nx = coarse.nx;
  system.ny = coarse.ny;
  system.hx *= 2;
  system.hy *= 2;
  rc_options options = options_;
  const auto set = [&](const char* key, const OptionValue& value) { options.values.set(options.context->option(key), value); };
  set(RC_OPT_TOL, std::max(coarse_tol, options_.real(RC_OPT_TOL)));
  Contact half(system, options, team_);
  half.surface_ = SurfaceState({coarse.nx, coarse.ny, coarse.gap, coarse.mask, true}, *team_);
  rc_step at = RC_STEP_INIT;
  at.control = step.control;
  at.target = step.target;
  if (half.nothing_touches(at)) return std::nullopt;

  Monitor watch(cancelled_, {}, monitor.time_left(), options_.integer(RC_OPT_MAX_ITER));
  std::optional<Answer> answer;
  if (const auto choice = choose_for_few(options, half.system_, at.control, {})) {
    std::optional<Estimate> estimate = half.coarse_estimate(at, monitor);
    if (!estimate) return std::nullopt;
    answer = half.solve_few(at, *choice, std::move(*estimate), watch);
    if (!answer) return std::nullopt;
  } else {
    answer = at.control == RC_CONTROL_LOAD ? half.at_load(at, watch, half.coarse_estimate(at, monitor))
                                           : half.at_displacement(at, watch);
  }
  if (!few(count_positive(answer->p), half.system_.points())) return std::nullopt;
  const Blocks blocks{system_.given.nx, system_.given.ny, 2};
  return Estimate{spread(half.pressures_of(*answer), blocks, surface_, Cut::same_pressure),
                  half.surface_.lowest() + answer->compression};
}

// The points at which the answer deflects the surface, and those outside that stay apart by less than the margin.
Deflected Contact::screened(const Answer& answer, double compression, double margin) {
  const TrialSet& trial = answer.op->trial();
  Deflected result;
  std::vector<double> y(answer.p.size()), depth;
  std::vector<std::int64_t> found;
  rc_screen request{};
  request.struct_size = sizeof request;
  request.approach = surface_.limit_of(compression + margin);
  request.gap = surface_.gap().data();
  request.mask = surface_.mask();
  request.tile_lowest = surface_.tile_lowest().data();
  request.y = y.data();
  request.room = std::max<std::int64_t>(1 << 16, 4 * trial.n);
  for (;;) {
    found.resize(static_cast<std::size_t>(request.room));
    depth.resize(found.size());
    request.found = found.data();
    request.depth = depth.data();
    request.unit = answer.length_unit;
    answer.op->screen(answer.p, request);
    if (request.n_found <= request.room) break;
    request.room = request.n_found;
  }
  std::vector<std::size_t> order(static_cast<std::size_t>(request.n_found));
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return found[a] < found[b]; });

  const std::size_t n = y.size() + order.size();
  result.pressures.on.n = static_cast<std::int64_t>(n);
  result.pressures.on.index.reserve(n);
  result.pressures.p.reserve(n);
  result.product.reserve(n);
  const auto put = [&](std::int64_t point, double p, double product) {
    result.pressures.on.index.push_back(point);
    result.pressures.p.push_back(p);
    result.product.push_back(product);
  };
  std::size_t next = 0;
  const auto put_found_below = [&](std::int64_t limit) {
    for (; next < order.size() && found[order[next]] < limit; ++next) {
      const std::int64_t point = found[order[next]];
      // As the backend took it, so that the approach and its round-off drop out.
      put(point, 0, request.approach - surface_.gap()[static_cast<std::size_t>(point)] - depth[order[next]]);
    }
  };
  for (std::size_t i = 0; i < y.size(); ++i) {
    const std::int64_t point = trial.point(static_cast<std::int64_t>(i));
    put_found_below(point);
    put(point, answer.p[i] * answer.pressure_unit, y[i] * answer.length_unit);
  }
  put_found_below(system_.points());
  if (result.pressures.on.n == system_.points()) result.pressures.on.index.clear();
  result.beyond = request.approach - surface_.lowest() - compression;
  return result;
}

// Unknowns around an estimated contact that lies in a small part of the grid: every point that the approach can reach.
TrialSet Contact::reachable(const Estimate& estimate, double limit) const {
  const std::int64_t box = surface_.extent_below(limit).box();
  return estimate.pressures.empty() || compact * box > system_.points() ? TrialSet{} : surface_.below(limit);
}

// Tiles that carry pressure or overlap under an estimate.
std::vector<std::int64_t> Contact::tiles_under(const Estimate& estimate, const Choice& choice) {
  Answer guess;
  guess.choice = choice;
  guess.length_unit = estimate.approach - surface_.lowest();
  guess.pressure_unit = guess.length_unit / system_.length_per_pressure;
  guess.op = &bound_operator(*choice.backend, estimate.pressures.on);
  guess.p = estimate.pressures.p;
  for (double& value : guess.p) value /= guess.pressure_unit;
  std::vector<std::int64_t> tiles;
  add_tiles(tiles, screened(guess, guess.length_unit, halo * guess.length_unit).on().index);
  return tiles;
}

// What overlaps by more than the certificate allows at points without pressure.
std::vector<std::int64_t> Contact::overlapping(const Deflected& found, double compression) const {
  const double allowed = 0.9 * options_.real(RC_OPT_TOL) * compression;
  std::vector<std::int64_t> points;
  for (std::size_t k = 0; k < found.size(); ++k)
    if (!(found.p()[k] > 0) && found.product[k] - (compression - surface_.height(found.point(k))) < -allowed)
      points.push_back(static_cast<std::int64_t>(found.point(k)));
  return points;
}

std::optional<Answer> Contact::solve_few(const rc_step& step, const Choice& choice, Estimate estimate, Monitor& monitor) {
  const bool by_load = step.control == RC_CONTROL_LOAD;
  const double lowest = surface_.lowest(), load = step.target / system_.cell_area();
  std::vector<std::int64_t> tiles;
  for (int round = 0;; ++round) {
    const double depth = estimate.approach - lowest;
    if (!(depth > 0) || estimate.pressures.empty()) return std::nullopt;
    const double limit = by_load ? estimate.approach + headroom * depth : step.target;
    TrialSet trial = reachable(estimate, limit);
    const bool whole = trial.n > 0;
    if (!whole && round == 0) tiles = tiles_under(estimate, choice);
    if (!whole) trial = surface_.below(limit, tiles);
    if (trial.n == 0) return std::nullopt;
    Answer answer;
    if (whole) {
      answer.choice = choose_for(trial, step.control);
      if (by_load && !(answer.choice.solver->controls & RC_CONTROL_LOAD)) return std::nullopt;
      answer.limit = limit - lowest;
      trial = widened(std::move(trial), answer.choice);
    } else {
      answer.choice = choice_ = choice;
    }
    answer.length_unit = depth;
    answer.pressure_unit = depth / system_.length_per_pressure;
    answer.op = &bound_operator(*answer.choice.backend, trial);
    answer.p = start(step, trial, answer.pressure_unit, &estimate.pressures);
    const double datum = by_load ? lowest : step.target;
    const std::vector<double> u = compenetrations(answer, datum);
    double d = by_load ? 1 : 0;
    answer.status =
        run(answer, monitor)(step.control, u, by_load ? load / answer.pressure_unit : 0, solver_tol(), datum, answer.p, d);
    answer.compression = by_load ? d * depth : compression(step);
    if (!std::isfinite(answer.compression)) return std::nullopt;

    estimate = {pressures_of(answer), by_load ? lowest + answer.compression : step.target};
    const bool last = answer.status != RC_OK || round == most_rounds;
    if (whole) {
      if (last || answer.compression <= limit - lowest) return answer;
      continue;
    }
    const double contacts = static_cast<double>(count_positive(answer.p));
    const double margin = std::min(halo, 30 * options_.real(RC_OPT_TOL) * std::sqrt(contacts)) * depth;
    Deflected all = screened(answer, answer.compression, margin);
    const std::vector<std::int64_t> more = overlapping(all, answer.compression);
    const std::size_t before = tiles.size();
    add_tiles(tiles, more);
    // Points of the tiles that a larger approach reaches are unknowns of the next round.
    const bool new_unknowns = tiles.size() > before || answer.compression > limit - lowest;
    if (more.empty() || last || !new_unknowns) {
      answer.checked = std::move(all);
      return answer;
    }
  }
}

}  // namespace rc
