#include "contact/grids/goal/accuracy_goal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/grid_contact.h"
#include "contact/grids/goal/grid_error.h"
#include "contact/proof/bounds.h"
#include "contact/proof/result.h"
#include "contact/step/target.h"
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
  return std::min(system.nx, system.ny) >= 2 * least_coarse_side && (even || system.boundary != RC_BOUNDARY_PERIODIC);
}

double relative(double difference, double value) {
  return value > 0 ? std::abs(difference) / value : std::numeric_limits<double>::infinity();
}

// Relative difference of load to the next coarser grid; in load control from the difference of approach and the stiffness.
double difference(const rc_result& fine, const rc_result& coarse, std::int32_t control) {
  if (control == RC_CONTROL_APPROACH) return relative(fine.load - coarse.load, fine.load);
  const double difference = coarse.stiffness * (fine.approach - coarse.approach);
  return std::isfinite(difference) ? relative(difference, fine.load) : std::numeric_limits<double>::infinity();
}

}  // namespace

AccuracyGoal::AccuracyGoal() = default;
AccuracyGoal::~AccuracyGoal() = default;

void AccuracyGoal::forget() {
  for (const Grid& grid : grids_) {
    grid.halved.contact().forget_steps();
    grid.halved.contact().forget_operators();
  }
  surface_ = -1;
}

Blocks AccuracyGoal::blocks_of(const Workspace& given, std::size_t k) {
  return {given.system.given.nx, given.system.given.ny, std::int64_t{1} << k};
}

// Puts the given surface on every coarser grid.
void AccuracyGoal::halve(GridContact& given) {
  const Workspace* finer = &given.work();
  for (std::size_t k = 0; can_be_halved(finer->system.given) && k < most_grids; ++k) {
    if (grids_.size() == k)
      grids_.push_back({HalvedGrid(*finer, given.work().options), {}, {}});
    else
      grids_[k].halved.renew(*finer);
    finer = &grids_[k].halved.contact().work();
  }
  surface_ = given.surfaces();
}

rc_status AccuracyGoal::solve_on(std::size_t k, const Workspace& given, const rc_step& step, const Monitor& monitor,
                                 std::optional<Estimate> estimate, bool with_gap) {
  Grid& grid = grids_[k - 1];
  GridContact& contact = grid.halved.contact();
  rc_options options = coarse_options(given.options, monitor);
  // difference() and look() need the stiffness.
  if (step.control == RC_CONTROL_LOAD) options.set(RC_OPT_STIFFNESS, std::int64_t{1});
  contact.set_options(options);
  contact.watched_by(monitor, true);
  rc_step on_grid = RC_STEP_INIT;
  on_grid.control = step.control;
  on_grid.target = step.target;
  on_grid.warm_start = step.warm_start;
  grid.result = {};
  grid.gap.resize(with_gap ? static_cast<std::size_t>(contact.work().system.points()) : 0);
  grid.result.gap = with_gap ? grid.gap.data() : nullptr;
  contact.begin(on_grid);
  if (nothing_touches(on_grid, contact.work())) return RC_UNCERTIFIED;
  Monitor watch = contact.monitor();
  return contact.solve_begun(on_grid, watch, grid.result, std::move(estimate));
}

AccuracyGoal::Found AccuracyGoal::from_coarse_to_fine(GridContact& given, const rc_step& step, const Monitor& monitor,
                                                      bool with_gap) {
  for (Grid& grid : grids_) grid.result = {};
  const double goal = given.work().goal.error, lowest = given.work().surface.lowest();
  try {
    if (surface_ != given.surfaces()) halve(given);
  } catch (const Error&) {
    return {};  // a coarser grid's gaps or cells are beyond double precision
  }
  const auto work = [&](std::size_t k) -> const Workspace& {
    return k > 0 ? grids_[k - 1].halved.contact().work() : given.work();
  };
  Found found;
  std::vector<GridLevel> levels;  // up to the coarsest grid with contact
  for (std::size_t k = grids_.size(); k >= 1; --k) {
    Grid& grid = grids_[k - 1];
    rc_status status = RC_UNCERTIFIED;
    try {
      status = solve_on(k, given.work(), step, monitor, std::exchange(found.estimate, {}), with_gap);
    } catch (const Error&) {
      // The whole grid may succeed where a coarser one failed.
    }
    if (const rc_status asked = monitor.ask(); asked != RC_OK || status == RC_STOP_CANCELLED) {
      // The last grid that was solved is better than nothing.
      const rc_status stop = asked != RC_OK ? asked : status;
      return {levels.empty() ? 0 : k + 1, stop, {}};
    }
    if (status != RC_OK || grid.result.contacts == 0) {
      levels.clear();
      continue;
    }
    const bool coarsest = levels.empty();
    if (coarsest) levels.resize(k + 1);
    if (!coarsest) levels[k].difference = difference(grid.result, grids_[k].result, step.control);
    const double approach = grid.result.approach;
    const auto spread_to = [&](std::size_t finer, const Blocks& blocks) {
      return Estimate{spread(grid.halved.contact().memory().last.pressures, blocks, work(finer).surface, Cut::same_pressure),
                      approach};
    };
    found.estimate = spread_to(k - 1, blocks_of(work(k - 1), 1));
    if (k + 2 >= levels.size()) continue;
    if (levels[k + 1].texture.points == 0)
      for (std::size_t j = 0; j < levels.size(); ++j)
        levels[j].texture = texture_below(approach, approach - lowest, work(j).surface, work(j).system.given);
    const GridErrors errors = guessed_errors(levels, k);
    if (errors.here <= goal) return {k, RC_WITHIN_GOAL, spread_to(0, blocks_of(given.work(), k))};
    if (k > 1 && !(errors.finest <= goal)) return {};  // no coarser grid will do; the whole grid makes its own start
  }
  return found;
}

void AccuracyGoal::add_work(rc_result& result) const {
  for (const Grid& grid : grids_) {
    result.iterations += grid.result.iterations;
    result.products += grid.result.products;
    result.setup_seconds += grid.result.setup_seconds;
  }
}

// Writes the answer of the last coarser grid that was solved, spread to the given grid.
void AccuracyGoal::deliver_stopped(Workspace& given, const rc_step& step, const Found& found, const Monitor& monitor,
                                   rc_result& result) {
  const Grid& grid = grids_[found.grid - 1];
  const GridContact& contact = grid.halved.contact();
  const rc_system &fine = given.system.given, &coarse = contact.work().system.given;
  const Blocks blocks = blocks_of(given, found.grid);
  const Pressures p = spread(contact.memory().last.pressures, blocks, given.surface, Cut::same_force);
  const OutputArray to_p = pressures_of(result), to_gap = gap_of(result);
  const std::size_t size = result.struct_size;
  result = grid.result;
  result.struct_size = size;
  result.p = to_p.in_double;
  result.p_single = to_p.in_single;
  result.gap = to_gap.in_double;
  result.gap_single = to_gap.in_single;
  if (given.options.integer(RC_OPT_STIFFNESS) == 0) result.stiffness = result.punch_stiffness = nan;
  result.stiffness_lower = result.stiffness_upper = nan;
  Bounds{}.write(result);
  result.points = given.system.points();
  result.contacts = p.on.n;
  double sum = 0;
  for (const double value : p.p) sum += value;
  result.load = sum * given.system.cell_area();
  result.mean_pressure = sum / static_cast<double>(given.system.points());
  result.contact_area = static_cast<double>(p.on.n) * given.system.cell_area();
  result.area_fraction = static_cast<double>(p.on.n) / static_cast<double>(given.system.points());
  result.max_pressure = p.p.empty() ? 0 : *std::ranges::max_element(p.p);
  if (step.control == RC_CONTROL_LOAD) result.kkt_control = load_imbalance(result.load, step.target);
  result.levels = 0;
  result.iterations = result.products = 0;
  result.setup_seconds = 0;
  add_work(result);
  result.seconds = std::max(0.0, monitor.seconds() - result.setup_seconds);
  given.record.accuracy = {
      sizeof(rc_accuracy), coarse.nx, coarse.ny, nan, nan, left_out(p, blocks, given.surface, contact.work().surface.gap())};
  result.status = found.status;
  set_message(join(rc_status_text(found.status), ": the answer is that of ", coarse.nx, "x", coarse.ny, " of ", fine.nx, "x",
                   fine.ny, " points")
                  .c_str());
  p.write(to_p, given.system.points(), given.team());
  for (std::int64_t i = 0; i < given.system.points() && to_gap.wanted(); ++i)
    to_gap.put(static_cast<std::size_t>(i), grid.gap[static_cast<std::size_t>(blocks.of(i))]);
}

bool AccuracyGoal::solve(GridContact& given, const rc_step& step, Monitor& monitor, rc_result& result,
                         std::optional<Estimate>& estimate) {
  Found found = from_coarse_to_fine(given, step, monitor, gap_of(result).wanted());
  if (found.status == RC_WITHIN_GOAL && look(given, step, found, monitor, result)) return true;
  if (found.status != RC_OK && found.grid > 0) {
    deliver_stopped(given.work(), step, found, monitor, result);
    return true;
  }
  if (found.status != RC_OK) {
    Answer stopped;
    stopped.status = found.status;
    Finished finished = certified_result(given.work(), step, std::move(stopped), monitor, result);
    if (finished.status == RC_OK) given.remember(std::move(finished), result);
    return true;
  }
  if (!step.p0) estimate = std::move(found.estimate);
  return false;
}

}  // namespace rc
