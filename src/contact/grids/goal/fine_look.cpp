// A look at the given grid: a few steps of the solve there correct a coarser grid's answer. They see all of the surface, so how
// much they change estimates the coarser answer's error from above. The error that they leave is much smaller.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/grid_contact.h"
#include "contact/grids/goal/accuracy_goal.h"
#include "contact/proof/result.h"
#include "contact/sparse/sparse_contact.h"
#include "contact/step/approach.h"
#include "core/error.h"

namespace rc {

namespace {

constexpr std::int64_t look_steps = 4;  // the pressures are cut at zero after the second and the last
constexpr double left_of_change = 0.5;  // share of the steps' change of load that may still be missing
constexpr double softest = 2;           // largest change of pressure that closes a gap on one cell, over E* gap / side

// Estimates how far pressures on the given grid are from the solution, by the gap where they act.
struct Remaining {
  double load = 0;  // of the pressures
  double gap = 0;   // mean |gap| over mean deflection, weighted by pressure: a relative error of the load
  double contacts = 0;
  double changes = 0;  // points that come into contact or out of it when the gap closes
};

Remaining remaining_of(const Deflected& found, const StepSurface& surface, double compression, const System& system) {
  const auto each = [&](const auto& visit) {
    for (std::size_t k = 0; k < found.size(); ++k)
      if (const std::size_t i = found.point(k); surface.included(i))
        visit(found.p()[k], found.product[k], found.product[k] - (compression - surface.height(i)));
  };
  Remaining rest;
  double force = 0, work = 0, open = 0, deflected = 0;
  each([&](double p, double deflection, double gap) {
    rest.contacts += p > 0;
    force += p;
    work += p * gap;
    open += p * std::abs(gap);
    deflected += p * deflection;
  });
  // The load closes the mean gap. Each point closes the rest of its own gap by itself.
  const double common = std::max(0.0, work / force);
  each([&](double p, double, double gap) {
    rest.changes += p > 0 ? p * system.length_per_pressure < softest * (gap - common) : gap < 0;
  });
  rest.load = force * system.cell_area();
  rest.gap = open / deflected;
  return rest;
}

}  // namespace

// True if the corrected answer is within the goal: it is then the result. If not, the whole grid starts from it.
bool AccuracyGoal::look(GridContact& given, const rc_step& step, Found& found, Monitor& monitor, rc_result& result) {
  const bool by_load = step.control == RC_CONTROL_LOAD;
  Workspace& work = given.work();
  const StepSurface& surface = work.surface;
  const System& system = work.system;
  const Grid& grid = grids_[found.grid - 1];
  const Workspace& coarse = grid.halved.contact().work();
  // Prescribes the coarser grid's approach in load control, too: the error of the load that belongs to it is what counts.
  rc_step at = RC_STEP_INIT;
  at.control = RC_CONTROL_APPROACH;
  at.target = found.estimate->approach;
  at.warm_start = 0;
  found.status = RC_OK;
  if (system.periodic() && surface.whole() && at.target >= surface.mean()) return false;  // no load belongs to it
  Answer answer;
  Deflected corrected;
  std::vector<double> kept;
  bool screened = false;
  rc_status ended = RC_OK;
  try {
    const struct Looking {
      std::int64_t& steps;
      explicit Looking(std::int64_t& look) : steps(look) { steps = look_steps; }
      ~Looking() { steps = 0; }
    } looking(work.record.look);
    std::optional<Answer> sparse = sparse_contact(work, given.memory(), at, monitor, found.estimate);
    answer = sparse ? std::move(*sparse) : at_approach(work, given.memory(), at, monitor, found.estimate);
    if (std::any_of(answer.p.begin(), answer.p.end(), [](double p) { return p < 0; })) answer.checked.reset();
    for (double& p : answer.p) p = std::max(0.0, p);
    screened = answer.checked.has_value();
    ended = std::exchange(answer.status, RC_OK);
    kept = answer.p;
    corrected = deflected(work, answer, gap_of(result).wanted());
  } catch (const Error&) {
    return false;  // another solver may do better
  }
  if (const rc_status stop = monitor.ask(); stop != RC_OK || ended == RC_STOP_CANCELLED) {
    found.status = stop != RC_OK ? stop : ended;
    return false;
  }
  double depth = answer.compression;
  const Remaining rest = remaining_of(corrected, surface, depth, system);
  if (!(rest.load > 0)) return false;

  // In load control the load at that approach is off by `change`, and the area is taken to be off by as much.
  const Blocks blocks = blocks_of(work, found.grid);
  const double change = std::abs(rest.load - grid.result.load) / rest.load;
  const double of_load = left_of_change * change + rest.gap;
  const double counted = (2 * rest.changes + static_cast<double>(blocks.factor * blocks.factor)) / rest.contacts;
  const double of_area = counted + rest.gap + (by_load ? change : 0);
  const double error = work.goal.of_area ? of_area : of_load;

  if (by_load) {
    const double factor = step.target / rest.load;
    for (double& p : kept) p *= factor;
    for (double& p : corrected.pressures.p) p *= factor;
    for (double& deflection : corrected.product) deflection *= factor;
    // The load is not proportional to the deflection if a stiffer part is just reached. An infinite stiffness is that of full
    // contact, in which no approach belongs to a load.
    const double rate = grid.result.stiffness;
    depth = std::isinf(rate) ? fitting_compression(work, corrected) : depth + (step.target - rest.load) / rate;
    // A larger approach reaches points that are not listed.
    const bool all = static_cast<std::int64_t>(corrected.size()) == system.points();
    if (!all && depth > answer.compression + (screened ? corrected.beyond : 0)) {
      answer.p = std::move(kept);
      corrected = deflected(work, answer, true);
    }
  }
  if (!(error <= work.goal.error) || std::isnan(depth)) {
    if (std::isnan(depth)) depth = answer.compression;
    found.estimate = Estimate{corrected.pressures.positive(work.team()), surface.lowest() + depth};
    return false;
  }
  name_components(work, answer, result);
  const bool wanted = work.options.integer(RC_OPT_STIFFNESS) != 0;
  certify_and_fill(work, step, corrected, depth, wanted ? grid.result.stiffness : std::numeric_limits<double>::quiet_NaN(),
                   result);
  std::copy(std::begin(grid.result.solver), std::end(grid.result.solver), result.solver);
  std::copy(std::begin(grid.result.backend), std::end(grid.result.backend), result.backend);
  result.status = RC_WITHIN_GOAL;
  result.modelled = answer.op->modelled();
  count_work(work, monitor, result);
  result.levels = 0;
  add_work(result);
  result.seconds = std::max(0.0, monitor.seconds() - result.setup_seconds);
  work.record.accuracy = {sizeof(rc_accuracy),
                          coarse.system.given.nx,
                          coarse.system.given.ny,
                          error,
                          of_area,
                          left_out(corrected.pressures, blocks, surface, coarse.surface.gap())};
  set_message(join(rc_status_text(RC_WITHIN_GOAL), ": accuracy ", work.goal.error, ", estimated error of the ",
                   work.goal.of_area ? "area " : "load ", error, " from ", coarse.system.given.nx, "x", coarse.system.given.ny,
                   " of ", system.given.nx, "x", system.given.ny, " points")
                  .c_str());
  write_arrays(work, corrected, depth, result);
  given.remember({result.status, std::move(corrected.pressures)}, result);
  return true;
}

}  // namespace rc
