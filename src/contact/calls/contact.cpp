#include "contact/calls/contact.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "contact/calls/controls.h"
#include "contact/operators.h"
#include "contact/slopes/derivatives.h"
#include "core/error.h"

namespace rc {

namespace {

void check_elastic(const System& system) {
  if (!system.creep.empty())
    fail(RC_ERR_INCOMPATIBLE, "derivatives are for elastic bodies, but rc_system.creep_terms is set; take differences of steps");
}

// The plastic indentation in rc_state, with the gap if it is to be kept; empty if it is null or all zeros.
Indentation indentation_of(const rc_state& state, const System& system) {
  const GapValues gap(std::span(values_of<double>(state.undeformed_gap), static_cast<std::size_t>(system.points())));
  const Indentation none = system.creep.empty() ? Indentation() : Indentation({}, gap);
  if (!state.indentation.data) return none;
  const std::span<const double> depth(values_of<double>(state.indentation), static_cast<std::size_t>(system.points()));
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (!(depth[i] >= 0 && std::isfinite(depth[i])))
      fail(RC_ERR_ARGUMENT, "rc_state.indentation[", i, "] = ", depth[i], " must be finite and >= 0");
    if (depth[i] > 0 && !system.capped())
      fail(RC_ERR_ARGUMENT, "rc_state.indentation[", i, "] = ", depth[i], " but the system has no hardness");
  }
  if (std::all_of(depth.begin(), depth.end(), [](double value) { return value == 0; })) return none;
  return {depth, gap};
}

Creep creep_of(const rc_state& state, const System& system) {
  const std::vector<PronyTerm>& terms = system.creep;
  if (terms.empty() && state.creep.data) fail(RC_ERR_ARGUMENT, "rc_state.creep is given but the system does not creep");
  if (terms.empty() || !state.p.data) return Creep(terms);
  if (!state.creep.data)
    fail(
        RC_ERR_ARGUMENT,
        "rc_state.creep is null but the system creeps and rc_state.p is given: steps go on only from what rc_contact_creep gave");
  const std::size_t values = (terms.size() + 1) * static_cast<std::size_t>(system.points());
  return {terms, {values_of<double>(state.creep), values}, state.time};
}

}  // namespace

Contact::Contact(const rc_system& system, const rc_options& options, const Company& company)
    : grid_(system, options, nullptr, company) {
  grid_.problem().goal = goal_of(options);
}

void Contact::set_options(const rc_options& options) {
  grid_.problem().set_options(options);
  grid_.problem().goal = goal_of(options);
}

void Contact::ask(const Asked& asked) {
  GridProblem& problem = grid_.problem();
  problem.options.set(RC_OPT_STIFFNESS, asked.stiffness);
  problem.options.set(RC_OPT_BOUNDS, asked.bounds);
  problem.goal.changes_bodies = asked.changes_bodies;
}

Prepared Contact::prepare(const rc_step& given) {
  const Pressed pressed = pressed_by(given, problem().system);
  const Step step = grid_.prepare(pressed.step);  // a step that is refused changes nothing
  start_solve();
  return {step, pressed.share};
}

void Contact::start_solve() {
  if (problem().options.integer(RC_OPT_RESUMABLE) != 0) goal_.forget();
}

Numbers Contact::solve(const rc_step& step, const Outputs& outputs) {
  OnHost host(grid_.problem(), held_, step, outputs, false);
  const Prepared prepared = prepare(host.step);
  const Cancellable cancellable(watcher());
  Numbers numbers = solve_prepared(prepared, host.outputs);
  host.give(outputs);
  return numbers;
}

Numbers Contact::solve_prepared(const Prepared& prepared, const Outputs& outputs) {
  Monitor monitor = grid_.monitor();
  return prepared.share ? at_area(prepared.step, *prepared.share, monitor, outputs) : at_target(prepared.step, monitor, outputs);
}

Numbers Contact::at_target(const Step& step, Monitor& monitor, const Outputs& outputs) {
  // With a hardness or creep the whole grid is solved: the error estimates of an accuracy goal hold for elastic contact.
  const System& system = problem().system;
  const bool coarser_may_do = problem().goal.error > 0 && system.halfspace() && !system.capped() && system.creep.empty() &&
                              step.target.touches(problem().surface);
  std::optional<Estimate> nearer;
  std::optional<Numbers> numbers;
  if (coarser_may_do) numbers = goal_.solve(grid_, step, monitor, outputs, nearer);
  if (!numbers) {
    numbers = grid_.solve_prepared(step, monitor, outputs, nearer);
    if (coarser_may_do) goal_.add_work(monitor, numbers->work);
  }
  return *numbers;
}

Numbers Contact::certify(const rc_step& step, const Outputs& outputs, std::optional<double> compression) {
  OnHost host(grid_.problem(), held_, step, outputs, true);
  const Pressed pressed = pressed_by(host.step, problem().system);
  if (pressed.share) fail(RC_ERR_ARGUMENT, "pressures are certified at a load, mean pressure or approach, not at an area");
  Numbers numbers = grid_.certify(pressed.step, host.outputs, compression);
  host.give(outputs);
  return numbers;
}

rc_status Contact::gradient(rc_gradient& gradient) {
  const Cancellable cancellable(watcher());
  check_elastic(system());
  const Rest after(grid_.problem());
  return differentiate(grid_.problem(), grid_.memory(), grid_.monitor(), gradient);
}

rc_status Contact::tangent(rc_tangent& tangent) {
  const Cancellable cancellable(watcher());
  check_elastic(system());
  const Rest after(grid_.problem());
  return differentiate(grid_.problem(), grid_.memory(), grid_.monitor(), tangent);
}

void Contact::forget(Forgotten what) {
  grid_.forget(what);
  if (what == Forgotten::grids)
    goal_.clear();
  else
    goal_.forget();
  drop_copies();
}

// After the surface has been cleared.
void Contact::drop_copies() {
  grid_.problem().gap_on_device = {};
  held_.clear();
}

void Contact::restore(const rc_state& state) {
  const System& system = problem().system;
  const auto n = static_cast<std::size_t>(system.points());
  if (!state.undeformed_gap.data) fail(RC_ERR_ARGUMENT, "rc_state.undeformed_gap is null");
  if (!state.p.data && state.p_before.data) fail(RC_ERR_ARGUMENT, "rc_state.p is null but rc_state.p_before is not");
  const std::span<const double> gap(values_of<double>(state.undeformed_gap), n);
  const std::span<const std::uint8_t> mask(values_of<std::uint8_t>(state.mask), state.mask.data ? n : 0);
  Indentation indentation = indentation_of(state, system);
  const std::vector<double> indented = indentation.indented();
  const bool summed = !indentation.none();
  StepSurface surface({system.given.nx, system.given.ny, summed ? GapValues(indented) : GapValues(gap), mask, false, 0, summed},
                      problem().team());
  Memory memory = memory_of(state, surface, system.points());
  Creep creep = creep_of(state, system);
  goal_.forget();
  grid_.restore(std::move(memory), std::move(surface), std::move(indentation), std::move(creep));
  drop_copies();
}

}  // namespace rc
