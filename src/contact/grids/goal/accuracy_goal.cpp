#include "contact/grids/goal/accuracy_goal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/grids/goal/grid_error.h"
#include "core/certificate_terms.h"
#include "core/error.h"
#include "core/limits.h"

namespace rc {

namespace {

constexpr std::int64_t least_coarse_side = 16;  // of a coarser grid
constexpr std::size_t most_grids = 12;

// A periodic grid must halve without a remainder, or its period would change.
bool can_be_halved(const rc_system& system) {
  const bool even = system.nx % 2 == 0 && system.ny % 2 == 0;
  return std::min(system.nx, system.ny) >= 2 * least_coarse_side && (even || system.boundary == RC_BOUNDARY_FREE);
}

double relative(double difference, double value) {
  return value > 0 ? std::abs(difference) / value : std::numeric_limits<double>::infinity();
}

// Relative difference of load to the next coarser grid; in load control from the difference of approach and the stiffness.
double difference(const Numbers& fine, double load, const Numbers& coarse, double coarse_load, bool by_load) {
  if (!by_load) return relative(load - coarse_load, load);
  const double difference = coarse.stiffness.value * (fine.approach - coarse.approach);
  return std::isfinite(difference) ? relative(difference, load) : std::numeric_limits<double>::infinity();
}

}  // namespace

AccuracyGoal::AccuracyGoal() = default;
AccuracyGoal::~AccuracyGoal() = default;

void AccuracyGoal::forget() {
  for (const Grid& grid : grids_) grid.contact->forget(Forgotten::steps);
  surface_ = -1;
}

Blocks AccuracyGoal::blocks_of(const GridProblem& given, std::size_t k) {
  return {given.system.given.nx, given.system.given.ny, std::int64_t{1} << k};
}

// Puts the given surface on every coarser grid.
void AccuracyGoal::halve(GridContact& given) {
  const GridProblem* finer = &given.problem();
  for (std::size_t k = 0; can_be_halved(finer->system.given) && k < most_grids; ++k) {
    CoarseGrid next = halved(*finer, 1);
    if (grids_.size() == k) {
      const rc_system system = halved_system(finer->system.given, 1);
      grids_.push_back({{}, std::make_unique<GridContact>(system, given.problem().options, &finer->team(), finer->company())});
    }
    grids_[k].contact->adopt(borrowed(next, finer->team()));
    grids_[k].surface = std::move(next);
    finer = &grids_[k].contact->problem();
  }
  surface_ = given.memory().surfaces;
}

rc_status AccuracyGoal::solve_on(std::size_t k, const GridProblem& given, const Step& step, const Monitor& monitor,
                                 const std::optional<Estimate>& estimate, bool with_gap) {
  Grid& grid = grids_[k - 1];
  GridContact& contact = *grid.contact;
  rc_options options = coarse_options(given.options, monitor);
  // difference() and look() need the stiffness.
  if (step.target.by_load()) options.set(RC_OPT_STIFFNESS, std::int64_t{1});
  contact.problem().set_options(options);
  contact.watcher().progress = reported_by(monitor);
  rc_step on_grid = RC_STEP_INIT;
  on_grid.control = step.target.control;
  on_grid.target = step.target.value;
  on_grid.warm_start = step.warm;
  grid.numbers = {};
  grid.gap.resize(with_gap ? static_cast<std::size_t>(contact.problem().system.points()) : 0);
  const Step prepared = contact.prepare(on_grid);
  if (!prepared.target.touches(contact.problem().surface)) return RC_UNCERTIFIED;
  Monitor watch = contact.monitor();
  grid.numbers = contact.solve_prepared(prepared, watch, {{}, {with_gap ? grid.gap.data() : nullptr}}, estimate);
  return grid.numbers.status;
}

AccuracyGoal::Found AccuracyGoal::from_coarse_to_fine(GridContact& given, const Step& step, const Monitor& monitor,
                                                      bool with_gap) {
  for (Grid& grid : grids_) grid.numbers = {};
  const double goal = given.problem().goal.error, lowest = given.problem().surface.lowest();
  try {
    if (surface_ != given.memory().surfaces) halve(given);
  } catch (const Error&) {
    return {};  // a coarser grid's gaps or cells are beyond double precision
  }
  const auto work = [&](std::size_t k) -> const GridProblem& {
    return k > 0 ? grids_[k - 1].contact->problem() : given.problem();
  };
  Found found;
  std::vector<GridLevel> levels;  // up to the coarsest grid with contact
  for (std::size_t k = grids_.size(); k >= 1; --k) {
    Grid& grid = grids_[k - 1];
    rc_status status = RC_UNCERTIFIED;
    try {
      status = solve_on(k, given.problem(), step, monitor, std::exchange(found.estimate, {}), with_gap);
    } catch (const Error&) {
      // The whole grid may succeed where a coarser one failed.
    }
    if (const rc_status asked = monitor.ask(); asked != RC_OK || status == RC_STOP_CANCELLED) {
      // The last grid that was solved is better than nothing.
      const rc_status stop = asked != RC_OK ? asked : status;
      return {levels.empty() ? 0 : k + 1, stop, {}};
    }
    if (status != RC_OK || grid.numbers.totals.contacts == 0) {
      levels.clear();
      continue;
    }
    const bool coarsest = levels.empty();
    if (coarsest) levels.resize(k + 1);
    const auto load_on = [&](const Grid& of) { return of.numbers.load(of.contact->problem().system); };
    if (!coarsest)
      levels[k].difference =
          difference(grid.numbers, load_on(grid), grids_[k].numbers, load_on(grids_[k]), step.target.by_load());
    const double approach = grid.numbers.approach;
    const auto spread_to = [&](std::size_t finer, const Blocks& blocks) {
      return Estimate{spread(grid.contact->memory().last.pressures, blocks, work(finer).surface, Cut::same_pressure), approach};
    };
    found.estimate = spread_to(k - 1, blocks_of(work(k - 1), 1));
    if (k + 2 >= levels.size()) continue;
    if (levels[k + 1].texture.points == 0)
      for (std::size_t j = 0; j < levels.size(); ++j)
        levels[j].texture = texture_below(approach, approach - lowest, work(j).surface, work(j).system.given);
    const GridErrors errors = guessed_errors(levels, k);
    if (errors.here <= goal) return {k, RC_WITHIN_GOAL, spread_to(0, blocks_of(given.problem(), k))};
    if (k > 1 && !(errors.finest <= goal)) return {};  // no coarser grid will do; the whole grid makes its own start
  }
  return found;
}

void AccuracyGoal::add_work(const Monitor& monitor, Work& work) const {
  for (const Grid& grid : grids_) {
    work.iterations += grid.numbers.work.iterations;
    work.products += grid.numbers.work.products;
    work.setup_seconds += grid.numbers.work.setup_seconds;
  }
  work.seconds = std::max(0.0, monitor.seconds() - work.setup_seconds);
}

// The answer of the last coarser grid that was solved, spread to the given grid.
Numbers AccuracyGoal::stopped(const GridProblem& given, const Step& step, const Found& found, const Monitor& monitor,
                              const Outputs& outputs) {
  const Grid& grid = grids_[found.grid - 1];
  const GridContact& contact = *grid.contact;
  const rc_system &fine = given.system.given, &coarse = contact.problem().system.given;
  const Blocks blocks = blocks_of(given, found.grid);
  const Pressures p = spread(contact.memory().last.pressures, blocks, given.surface, Cut::same_force);
  Numbers numbers = grid.numbers;
  if (given.options.integer(RC_OPT_STIFFNESS) == 0) numbers.stiffness.value = numbers.punch_stiffness = nan;
  numbers.stiffness.lower = numbers.stiffness.upper = nan;
  numbers.bounds = {};
  Totals& totals = numbers.totals;
  // The energy and the plastic volume of the coarser grid, in the cells of this one.
  const double cells = contact.problem().system.cell_area() / given.system.cell_area();
  totals.energy *= cells;
  totals.overlap *= cells;
  totals.contacts = p.on.n;
  totals.sum = 0;
  for (const double value : p.p) totals.sum += value;
  totals.max_pressure = p.p.empty() ? 0 : *std::ranges::max_element(p.p);
  if (step.target.by_load()) numbers.certificate.control = load_imbalance(numbers.load(given.system), step.target.value);
  numbers.work = {};
  add_work(monitor, numbers.work);
  numbers.accuracy = {coarse.nx, coarse.ny, nan, nan, left_out(p, blocks, given.surface, contact.problem().surface.gap())};
  numbers.status = found.status;
  set_message(join(rc_status_text(found.status), ": the answer is that of ", coarse.nx, "x", coarse.ny, " of ", fine.nx, "x",
                   fine.ny, " points")
                  .c_str());
  p.write(outputs.p, given.system.points(), given.team());
  for (std::int64_t i = 0; i < given.system.points() && outputs.gap.wanted(); ++i)
    outputs.gap.put(static_cast<std::size_t>(i), grid.gap[static_cast<std::size_t>(blocks.of(i))]);
  return numbers;
}

std::optional<Numbers> AccuracyGoal::solve(GridContact& given, const Step& step, Monitor& monitor, const Outputs& outputs,
                                           std::optional<Estimate>& estimate) {
  Found found = from_coarse_to_fine(given, step, monitor, outputs.gap.wanted());
  if (found.status == RC_WITHIN_GOAL)
    if (std::optional<Numbers> within = look(given, step, found, monitor, outputs)) return within;
  if (found.status != RC_OK && found.grid > 0) return stopped(given.problem(), step, found, monitor, outputs);
  if (found.status != RC_OK) {
    Answer none;
    none.status = found.status;
    StepResult result = certify_and_write(given.problem(), step.target, std::move(none), Attempt{monitor}, outputs);
    Numbers numbers = result.numbers;
    if (numbers.status == RC_OK) given.remember(std::move(result), {});
    return numbers;
  }
  if (!step.p0.data) estimate = std::move(found.estimate);
  return std::nullopt;
}

}  // namespace rc
