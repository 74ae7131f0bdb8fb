// A look at the given grid: a few steps of the solve there correct a coarser grid's answer. They see all of the surface, so how
// much they change estimates the coarser answer's error from above. The error that they leave is much smaller.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/grids/goal/accuracy_goal.h"
#include "contact/step/sparse_contact.h"
#include "contact/step/whole_contact.h"
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

// The corrected answer if it is within the goal. If not, the whole grid starts from it.
std::optional<Numbers> AccuracyGoal::look(GridContact& given, const Step& step, Found& found, Monitor& monitor,
                                          const Outputs& outputs) {
  const bool by_load = step.target.by_load();
  const GridProblem& problem = given.problem();
  const StepSurface& surface = problem.surface;
  const System& system = problem.system;
  const Grid& grid = grids_[found.grid - 1];
  const GridProblem& coarse = grid.contact->problem();
  // Also prescribes the coarser grid's approach in load control, because the goal is about the load that belongs to it.
  const Target at{RC_CONTROL_APPROACH, found.estimate->approach};
  found.status = RC_OK;
  const auto mean_gap = [&] { return surface.lowest() + surface.moments().mean; };
  if (system.periodic() && surface.range().whole && at.value >= mean_gap()) return std::nullopt;  // no load belongs to it
  Answer answer;
  Deflected corrected;
  std::vector<double> kept;
  bool screened = false;
  rc_status ended = RC_OK;
  const Attempt attempt{.monitor = monitor, .warm = step.warm, .look = look_steps};
  try {
    std::optional<Answer> sparse;
    if (const std::optional<Choice> few = choose_for_few(problem, at.control))
      sparse = sparse_contact_near(*found.estimate, problem, at, *few, attempt);
    answer = sparse ? std::move(*sparse) : whole_contact(problem, at, {}, attempt, found.estimate);
    if (std::any_of(answer.p.begin(), answer.p.end(), [](double p) { return p < 0; })) answer.checked.reset();
    for (double& p : answer.p) p = std::max(0.0, p);
    screened = answer.checked.has_value();
    ended = std::exchange(answer.status, RC_OK);
    kept = answer.p;
    corrected = deflected(problem, answer, outputs.gap.wanted());
  } catch (const Error&) {
    return std::nullopt;  // another solver may do better
  }
  if (const rc_status stop = monitor.ask(); stop != RC_OK || ended == RC_STOP_CANCELLED) {
    found.status = stop != RC_OK ? stop : ended;
    return std::nullopt;
  }
  double depth = answer.compression;
  const Remaining rest = remaining_of(corrected, surface, depth, system);
  if (!(rest.load > 0)) return std::nullopt;

  // In load control the load at that approach is off by `change`, and the area is taken to be off by as much.
  const Blocks blocks = blocks_of(problem, found.grid);
  const double coarse_load = grid.numbers.load(coarse.system);
  const double change = std::abs(rest.load - coarse_load) / rest.load;
  const double of_load = left_of_change * change + rest.gap;
  const double counted = (2 * rest.changes + static_cast<double>(blocks.factor * blocks.factor)) / rest.contacts;
  const double of_area = counted + rest.gap + (by_load ? change : 0);
  const double error = problem.goal.of_area ? of_area : of_load;

  if (by_load) {
    const double factor = step.target.value / rest.load;
    for (double& p : kept) p *= factor;
    for (double& p : corrected.pressures.p) p *= factor;
    for (double& deflection : corrected.product) deflection *= factor;
    // The load is not proportional to the deflection if a stiffer part is just reached. An infinite stiffness is that of full
    // contact, in which no approach belongs to a load.
    const double rate = grid.numbers.stiffness.value;
    depth = std::isinf(rate) ? fitting_compression(problem, corrected) : depth + (step.target.value - rest.load) / rate;
    // A larger approach reaches points that are not listed.
    const bool all = static_cast<std::int64_t>(corrected.size()) == system.points();
    if (!all && depth > answer.compression + (screened ? corrected.beyond : 0)) {
      answer.p = std::move(kept);
      corrected = deflected(problem, answer, true);
    }
  }
  if (!(error <= problem.goal.error) || std::isnan(depth)) {
    if (std::isnan(depth)) depth = answer.compression;
    found.estimate = Estimate{corrected.pressures.positive(problem.team()), surface.lowest() + depth};
    return std::nullopt;
  }
  const bool wanted = problem.options.integer(RC_OPT_STIFFNESS) != 0;
  const double rate = wanted ? grid.numbers.stiffness.value : std::numeric_limits<double>::quiet_NaN();
  Numbers numbers = certified_numbers(problem, step.target, answer, corrected, depth, rate, attempt);
  copy_text(numbers.solver, grid.numbers.solver);
  copy_text(numbers.backend, grid.numbers.backend);
  numbers.status = RC_WITHIN_GOAL;
  numbers.work = work_of(problem, monitor);
  add_work(monitor, numbers.work);
  numbers.accuracy = {coarse.system.given.nx, coarse.system.given.ny, error, of_area,
                      left_out(corrected.pressures, blocks, surface, coarse.surface.gap())};
  set_message(join(rc_status_text(RC_WITHIN_GOAL), ": accuracy ", problem.goal.error, ", estimated error of the ",
                   problem.goal.of_area ? "area " : "load ", error, " from ", coarse.system.given.nx, "x", coarse.system.given.ny,
                   " of ", system.given.nx, "x", system.given.ny, " points")
                  .c_str());
  write_arrays(problem, corrected, depth, outputs);
  given.remember({numbers, std::move(corrected.pressures)}, answer.choice);
  return numbers;
}

}  // namespace rc
